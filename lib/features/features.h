/// \file Feature curves and their seeds (docs/METHOD.md#features).
#pragma once

#include "base/length.h"
#include "basecomplex/base_complex.h"
#include "mesh/dihedral.h"
#include "mesh/quad_mesh.h"
#include "mesh/roundness.h"

#include <vector>

namespace qm {

struct FeatureOptions {
    double rho = defaultRho; ///< smallest dihedral angle of the edges of a curve, radians
    // Distances of ends are measured along the line to the next extraordinary vertex; where a sharp line
    // crosses, they do not count. Such a line is sharper than `rho`, and on one side than `shortRho`.
    Length minLength{3, true};   ///< smallest length of a curve
    Length minDistance{1, true}; ///< smallest distance of its ends from extraordinary vertices
    int tau = 6;                 ///< smallest number of edges of a curve
    /// In place of rho for curves with fewer edges, which must end at the boundary or at other edges as
    /// sharp: a short fold of a sheet, or an upright edge of a plate. Pi leaves all of them out, and lets no
    /// line divide others.
    double shortRho = 0.7;
    int zeta = 1; ///< its ends are more than this many edges away from extraordinary vertices
    double maxRoundness = roundLine; ///< of a curve, see `roundness`; 1 admits all
};

/// A run of sharp edges along one mesh line, or a part of one between lines that cross. A closed loop repeats
/// its first vertex at the end.
struct FeatureCurve {
    std::vector<HalfedgeId> halfedges;
    /// Where the curve's two particles start: the middle vertex, or the nearest one along the curve that is
    /// interior, regular and no seed of another curve.
    VertexId seed;
};

struct Features {
    std::vector<FeatureCurve> curves;
};

/// Finds all maximal curves, in time linear in the mesh, ordered by their lowest edge index. Those that sharp
/// lines cross are divided there, into parts with vertices that none crosses. If the line beyond an end is
/// closed or reaches the boundary first, or a sharp line crosses there, the end counts as infinitely far from
/// extraordinary vertices. A curve without an admissible seed is left out.
[[nodiscard]] Features findFeatures(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                    const FeatureOptions& options);

/// The seeds of the curves, for `buildBaseComplex`, in the curves' order.
[[nodiscard]] std::vector<Seed> seeds(const QuadMesh& mesh, const Features& features);

} // namespace qm

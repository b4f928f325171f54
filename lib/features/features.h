/// \file Feature curves and their seeds (docs/METHOD.md#features).
#pragma once

#include "base/length.h"
#include "basecomplex/base_complex.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

struct FeatureOptions {
    double rho = 0.45; ///< every edge of a curve is sharper than this, radians
    // Ends are measured along the line to the next extraordinary vertex.
    Length minLength{3, true};   ///< a curve is at least this long
    Length minDistance{1, true}; ///< its ends are at least this far from any extraordinary vertex
    int tau = 6;                 ///< a curve has at least this many edges
    int zeta = 1;                ///< its ends are more than this many edges from any extraordinary vertex
};

/// A run of sharp edges along one mesh line. A closed loop repeats its first vertex at the end.
struct FeatureCurve {
    std::vector<HalfedgeId> halfedges;
    /// Where its two particles start: the middle vertex, or the nearest to it along the curve that is
    /// interior, regular and no other curve's seed.
    VertexId seed;
};

struct Features {
    std::vector<FeatureCurve> curves;
};

/// Finds all maximal curves, in time linear in the mesh; ordered by their lowest edge index. An end that no
/// extraordinary vertex follows along the line, because the boundary comes first or the line is closed, is
/// infinitely far from any. A curve without a vertex that may be its seed is left out.
[[nodiscard]] Features findFeatures(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                    const FeatureOptions& options);

/// The seeds of the curves, for `buildBaseComplex`, in the curves' order.
[[nodiscard]] std::vector<Seed> seeds(const QuadMesh& mesh, const Features& features);

} // namespace qm

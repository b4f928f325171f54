/// \file How far surfaces are from the mesh and from one another (docs/METHOD.md#measuring).
#pragma once

#include "base/control.h"
#include "bspline/borders.h"
#include "bspline/mesh_distance.h"
#include "bspline/quad_grid.h"
#include "bspline/surfaces.h"
#include "layout/layout.h"

#include <array>
#include <cmath>
#include <vector>

namespace qm {

struct DeviationOptions {
    double rho = 0.45;      ///< kinks count across border edges of at most this dihedral angle, radians
    int samplesPerEdge = 2; ///< steps of the lattice of samples along every mesh edge; at least 1
};

struct MeasuredDeviation {
    Deviation ofAll;
    std::vector<Deviation> ofPatch; ///< in the order of the patches
};

/// Where a patch is too far from its quads, or turned away from them or from its neighbour.
struct DeviatingPlace {
    std::array<double, 2> at{}; ///< u and v
    double distance = 0;        ///< 0 if the normal alone is to blame
};

/// Of every patch.
using DeviatingPlaces = std::vector<std::vector<DeviatingPlace>>;

/// What is told with its place if it is larger.
struct DeviationLimits {
    double farthest = HUGE_VAL; ///< distance between surface and mesh
    double mostBent = 180;      ///< normal deviation, degrees
    double mostKinked = 180;    ///< kink that the quads do not have, degrees
};

/// Samples every quad at the same lattice on surface and mesh. From the surface to the mesh the distance is
/// that to the nearest quad of the whole mesh; from the mesh to the surface it is that to the segment's own
/// patch. Gaps are the distances between the points that neighbours have at the same place of their common
/// border, and kinks the angles between the normals there. All samples weigh the same. Patches are given in
/// the order of the segments, each parameterised like its segment's grid.
class DeviationMeter {
public:
    /// What is passed must outlive the meter.
    /// \param dihedralAngles  by edge index
    DeviationMeter(const QuadMesh& mesh, const Layout& layout, const std::vector<double>& dihedralAngles,
                   const DeviationOptions& options);

    /// Length of the diagonal of the bounding box of all vertices that a face uses.
    [[nodiscard]] double diagonal() const { return diagonal_; }

    [[nodiscard]] MeasuredDeviation measure(const std::vector<Patch>& patches,
                                            const Control& control = {}) const;

    /// Much faster than to measure: only what may be beyond the limits is looked at closely.
    /// \param only  patches to be looked at, with their borders; all if it is empty
    [[nodiscard]] DeviatingPlaces find(const std::vector<Patch>& patches, const DeviationLimits& limits,
                                       const std::vector<bool>& only = {}, const Control& control = {}) const;

private:
    [[nodiscard]] QuadGrid quads(std::size_t patch) const;
    [[nodiscard]] bool isSmooth(const BorderEdge& border) const;

    const QuadMesh& mesh_;
    const Layout& layout_;
    const std::vector<double>& dihedralAngles_;
    DeviationOptions options_;
    MeshDistance distance_;
    double diagonal_;
    std::vector<BorderEdge> borders_;
};

} // namespace qm

/// \file How far surfaces are from the mesh and from one another (paper 5, its figure 21).
#pragma once

#include "base/control.h"
#include "bspline/surfaces.h"
#include "merge/layout.h"

#include <array>
#include <cmath>
#include <vector>

namespace qm {

struct DeviationOptions {
    double rho = 0.45;           ///< kinks count across border edges of at most this dihedral angle, radians
    int samplesPerEdge = 2;      ///< steps of the lattice of samples along every mesh edge; at least 1
    double farthest = HUGE_VAL;  ///< what is farther is told with its place
    double mostBent = 180;       ///< so are larger normal deviations, degrees
    double mostKinked = 180;     ///< and larger kinks that the quads do not have, degrees
    std::vector<bool> only = {}; ///< patches to be measured, with their borders; all if it is empty
};

/// Where a patch is too far from its quads, or turned away from them or from its neighbour.
struct DeviatingPlace {
    std::array<double, 2> at{}; ///< u and v
    double distance = 0;        ///< 0 if the normal alone is to blame
};

struct MeasuredDeviation {
    Deviation ofAll;
    std::vector<Deviation> ofPatch;                  ///< in the order of the patches
    std::vector<std::vector<DeviatingPlace>> places; ///< of every patch
};

/// Samples every quad at the same lattice on surface and mesh. From the surface to the mesh the distance is
/// that to the nearest quad of the whole mesh; from the mesh to the surface it is that to the segment's own
/// patch, found by Gauss and Newton's iteration from the sample's parameters: where it is not exact, it is
/// too large. Gaps are the distances between the points that neighbours have at the same place of their
/// common border, and kinks the angles between the normals there. All samples weigh the same. \param patches
/// in the order of the segments, each parameterised like its segment's grid
[[nodiscard]] MeasuredDeviation measureDeviation(const QuadMesh& mesh, const Layout& layout,
                                                 const std::vector<double>& dihedralAngles,
                                                 const std::vector<Patch>& patches,
                                                 const DeviationOptions& options,
                                                 const Control& control = {});

/// Length of the diagonal of the bounding box of all vertices that a face uses.
[[nodiscard]] double boundingBoxDiagonal(const QuadMesh& mesh);

} // namespace qm

/// \file The two vertices of a list that are farthest apart over the surface (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/surface_distances.h"

#include <vector>

namespace qm {

struct FarthestPair {
    std::size_t first = 0; ///< positions in the list; first < second
    std::size_t second = 0;
    std::vector<double> fromFirst; ///< distances to every vertex of the list
    std::vector<double> fromSecond;
};

/// Measures distances from few of the vertices, because by the triangle inequality most pairs cannot be the
/// farthest. If a few dozen sweeps suffice, as they nearly always do, the answer is exact, as far as the
/// distances are a metric. Beyond that, as on a sphere, where all pairs of antipodes compete, each sweep
/// allows an error of another per cent, so that the search ends soon.
/// \param vertices  at least two, different, in one connected part
[[nodiscard]] FarthestPair farthestPair(const std::vector<VertexId>& vertices, SurfaceDistances& distances);

} // namespace qm

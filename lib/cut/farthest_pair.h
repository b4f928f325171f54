/// \file Which two of some vertices are farthest apart over the surface (docs/METHOD.md#mesh-cut).
#pragma once

#include "cut/surface_distances.h"

#include <vector>

namespace qm {

struct FarthestPair {
    std::size_t first = 0; ///< positions in the list of vertices, first < second
    std::size_t second = 0;
    std::vector<double> fromFirst; ///< distances to every vertex of the list
    std::vector<double> fromSecond;
};

/// Sweeps from few of the vertices: by the triangle inequality, most pairs cannot be the farthest. The answer
/// is exact, as far as the distances are a metric, if a few dozen sweeps settle it, as they nearly always do.
/// Beyond that, as on a sphere, where all pairs of antipodes compete, each sweep admits another per cent
/// of error, so that the search ends soon.
/// \param vertices  at least two, of one part, different from each other
[[nodiscard]] FarthestPair farthestPair(const std::vector<VertexId>& vertices, SurfaceDistances& distances);

} // namespace qm

#include "bspline/closeness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// Vertices of a segment less than `reach` edges from a place along both directions.
std::vector<std::size_t> around(const std::vector<VertexId>& grid, const std::array<int, 2>& size,
                                const std::array<double, 2>& at, int reach) {
    std::array<std::array<int, 2>, 2> range;
    for (std::size_t d = 0; d < 2; ++d)
        range[d] = {std::max(static_cast<int>(std::ceil(at[d])) - reach, 0),
                    std::min(static_cast<int>(std::floor(at[d])) + reach, size[d])};
    const auto width = static_cast<std::size_t>(size[0]) + 1;
    std::vector<std::size_t> vertices;
    for (int j = range[1][0]; j <= range[1][1]; ++j)
        for (int i = range[0][0]; i <= range[0][1]; ++i)
            if (std::abs(i - at[0]) < reach && std::abs(j - at[1]) < reach)
                vertices.push_back(static_cast<std::size_t>(
                    grid[static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i)].idx()));
    return vertices;
}

} // namespace

void comeCloser(const QuadMesh& mesh, const Layout& layout, const DeviatingPlaces& places, double tolerance,
                std::vector<Closeness>& closeness) {
    constexpr double leastShare = 0.7;
    constexpr double mostShare = 0.9;
    const auto known = closeness;
    for (std::size_t patch = 0; patch < places.size(); ++patch) {
        if (places[patch].empty()) continue;
        const Segment& segment = layout.segments[patch];
        const auto grid = vertexGrid(mesh, segment);
        for (const DeviatingPlace& place : places[patch]) {
            const double needed = place.distance > 0 ? 0.96 * tolerance / place.distance : 0;
            const double share = std::clamp(needed, leastShare, mostShare);
            const int farthest = std::max(segment.size[0], segment.size[1]) + 1;
            bool asked = false;
            for (int reach = 1; reach <= farthest && !asked; ++reach)
                for (const std::size_t k : around(grid, segment.size, place.at, reach)) {
                    if (!known[k].slides) continue;
                    asked = true;
                    if (reach > 1 || known[k].share < 1)
                        closeness[k] = {1, false};
                    else if (closeness[k].slides)
                        closeness[k].share = std::min(closeness[k].share, share);
                }
        }
    }
}

} // namespace qm

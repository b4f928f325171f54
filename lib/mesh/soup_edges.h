/// \file Which sides of a soup's quads lie on the same edge.
#pragma once

#include "mesh/soup.h"

#include <cstdint>
#include <vector>

namespace qm {

/// Side 4 * f + k of quad f leads from its corner k to the next.
using Side = std::uint32_t;

/// Sides in groups: each group holds all sides between the same two vertices.
struct SoupEdges {
    std::vector<Side> sides;        ///< group after group, within a group ascending
    std::vector<std::size_t> begin; ///< where group k begins; one more than groups

    [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
    [[nodiscard]] std::span<const Side> edge(std::size_t k) const {
        return {sides.data() + begin[k], sides.data() + begin[k + 1]};
    }
};

/// \param soup  all its polygons are quads with indices in range
[[nodiscard]] SoupEdges findEdges(const Soup& soup);

[[nodiscard]] inline std::int64_t sideFrom(const Soup& soup, Side side) {
    return soup.corners[side];
}
[[nodiscard]] inline std::int64_t sideTo(const Soup& soup, Side side) {
    return soup.corners[(side & ~3U) | ((side + 1) & 3U)];
}

} // namespace qm

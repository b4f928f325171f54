/// \file Finding the sides of a soup's polygons that lie on the same edge.
#pragma once

#include "mesh/orientation.h"
#include "mesh/soup/soup.h"

#include <span>
#include <vector>

namespace qm {

/// Sides in groups: each group holds all sides between the same two vertices.
struct SoupEdges {
    std::vector<Side> sides;        ///< group after group, within a group ascending
    std::vector<std::size_t> begin; ///< where group k begins; one more than groups

    [[nodiscard]] std::size_t count() const { return begin.size() - 1; }
    [[nodiscard]] std::span<const Side> edge(std::size_t k) const {
        return {sides.data() + begin[k], sides.data() + begin[k + 1]};
    }
};

/// Linear but for sorting the few sides at each vertex. The side from a polygon's corner to the next one has
/// the corner's number.
/// \param soup  polygons with indices in range
[[nodiscard]] SoupEdges findEdges(const Soup& soup);

// For soups whose polygons are all quads with indices in range.

/// For every side, the other one on its edge; none on the boundary, and if more than two sides share the
/// edge.
[[nodiscard]] std::vector<Side> twinSides(const Soup& soup, const SoupEdges& edges);

/// Two quads are neighbours if they are the only ones at an edge.
/// \param twins  the result of `twinSides`
[[nodiscard]] Orientation findOrientation(const Soup& soup, const std::vector<Side>& twins);

[[nodiscard]] inline std::int64_t sideFrom(const Soup& soup, Side side) {
    return soup.corners[side];
}

/// The next or the previous side in the same quad.
[[nodiscard]] constexpr Side nextSide(Side side) {
    return (side & ~3U) | ((side + 1) & 3U);
}
[[nodiscard]] constexpr Side previousSide(Side side) {
    return (side & ~3U) | ((side + 3) & 3U);
}

[[nodiscard]] inline std::int64_t sideTo(const Soup& soup, Side side) {
    return soup.corners[nextSide(side)];
}

} // namespace qm

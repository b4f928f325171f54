#include "bspline/reference/boundary_sides.h"

#include "base/at.h"

#include <algorithm>
#include <cstdint>

namespace qm {

BoundarySides boundarySides(const Triangles& triangles) {
    struct Side {
        int low = 0; ///< the lower of its points
        int high = 0;
        std::uint32_t number = 0;
    };
    std::vector<Side> sides;
    sides.reserve(3 * triangles.faces.size());
    for (const auto& face : triangles.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
            sides.push_back({low, high, static_cast<std::uint32_t>(sides.size())});
        }
    const auto ends = [](const Side& side) { return std::pair(side.low, side.high); };
    std::ranges::sort(sides, {}, ends);
    BoundarySides result{std::vector<bool>(sides.size()), std::vector<bool>(triangles.points.size())};
    for (auto side = sides.begin(); side != sides.end();) {
        const auto next =
            std::find_if(side, sides.end(), [&](const Side& s) { return ends(s) != ends(*side); });
        if (next - side == 1) {
            result.sides[side->number] = true;
            result.points[at(side->low)] = true;
            result.points[at(side->high)] = true;
        }
        side = next;
    }
    return result;
}

} // namespace qm

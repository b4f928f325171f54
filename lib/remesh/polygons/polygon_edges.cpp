#include "remesh/polygons/polygon_edges.h"

#include "base/at.h"
#include "base/groups.h"
#include "mesh/angle_between.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace qm {
namespace {

struct Side {
    std::array<std::int64_t, 2> ends; ///< the lower one first
    std::size_t corner;
    std::size_t face;
    bool ascends;
};

/// Those of one edge beside each other, in the order of their corners.
std::vector<Side> sortedSides(const Soup& soup) {
    std::vector<Side> sides;
    sides.reserve(soup.corners.size());
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const auto corners = soup.face(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::int64_t from = corners[k], to = corners[(k + 1) % corners.size()];
            sides.push_back({{std::min(from, to), std::max(from, to)}, sides.size(), face, from < to});
        }
    }
    std::ranges::sort(sides, {}, [](const Side& side) { return std::tuple(side.ends, side.corner); });
    return sides;
}

} // namespace

Point areaVector(const Soup& soup, std::size_t face) {
    const auto corners = soup.face(face);
    const auto fromFirst = [&](std::size_t k) {
        return soup.points[at(corners[k])] - soup.points[at(corners[0])];
    };
    Point sum(0, 0, 0);
    for (std::size_t k = 2; k < corners.size(); ++k)
        sum += fromFirst(k - 1) % fromFirst(k);
    return sum;
}

PolygonEdges polygonEdges(const Soup& soup, double rho) {
    const std::vector<Side> sides = sortedSides(soup);
    const auto isSmooth = [&](std::span<const Side> group) {
        return group.size() == 2 && group[0].ascends != group[1].ascends &&
               angleBetween(areaVector(soup, group[0].face), areaVector(soup, group[1].face)) <= rho;
    };
    std::vector<std::size_t> firstCorner(sides.size()); // by corner: the first one whose side has its edge
    std::vector<bool> sharp(sides.size());              // by such a corner
    forEachGroup(sides, &Side::ends, [&](std::span<const Side> group) {
        sharp[group[0].corner] = !isSmooth(group);
        for (const Side& side : group)
            firstCorner[side.corner] = group[0].corner;
    });
    PolygonEdges edges;
    edges.edgeOf.resize(sides.size());
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const auto corners = soup.face(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t corner = soup.faceBegins[face] + k;
            if (firstCorner[corner] != corner) {
                edges.edgeOf[corner] = edges.edgeOf[firstCorner[corner]];
                continue;
            }
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
            edges.edgeOf[corner] = edges.ends.size();
            edges.ends.push_back({low, high});
            edges.isSharp.push_back(sharp[corner]);
        }
    }
    return edges;
}

} // namespace qm

#include "remesh/polygons/polygon_edges.h"

#include "base/at.h"
#include "mesh/angle_between.h"
#include "mesh/soup/soup_edges.h"

#include <algorithm>
#include <span>

namespace qm {

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
    const SoupEdges groups = findEdges(soup);
    std::vector<std::size_t> groupOf(soup.corners.size()); // of the side that begins at a corner
    for (std::size_t group = 0; group < groups.count(); ++group)
        for (const Side side : groups.edge(group))
            groupOf[side] = group;
    const auto isSmooth = [&](std::span<const Side> sides) {
        return sides.size() == 2 && sideFrom(soup, sides[0]) != sideFrom(soup, sides[1]) &&
               angleBetween(areaVector(soup, soup.faceOf(sides[0])),
                            areaVector(soup, soup.faceOf(sides[1]))) <= rho;
    };
    PolygonEdges edges;
    edges.edgeOf.resize(soup.corners.size());
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const auto corners = soup.face(face);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t corner = soup.faceBegins[face] + k;
            const auto sides = groups.edge(groupOf[corner]);
            if (sides[0] != corner) {
                edges.edgeOf[corner] = edges.edgeOf[sides[0]];
                continue;
            }
            const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
            edges.edgeOf[corner] = edges.ends.size();
            edges.ends.push_back({low, high});
            edges.isSharp.push_back(!isSmooth(sides));
        }
    }
    return edges;
}

} // namespace qm

#include "mesh/soup/soup_edges.h"

#include "base/at.h"

#include <algorithm>
#include <utility>

namespace qm {

SoupEdges findEdges(const Soup& soup) {
    // Linear time: sorts the sides into buckets by their lower vertex, then within these small buckets.
    const auto sideCount = static_cast<Side>(soup.corners.size());
    const auto forEachSide = [&](const auto& visit) { // with its lower and its higher end
        Side side = 0;
        for (std::size_t face = 0; face < soup.faceCount(); ++face) {
            const auto corners = soup.face(face);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const auto [low, high] = std::minmax(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
                visit(side++, low, high);
            }
        }
    };
    std::vector<std::size_t> bucketBegin(soup.points.size() + 2, 0);
    forEachSide([&](Side, std::int64_t low, std::int64_t) { ++bucketBegin[at(low) + 2]; });
    for (std::size_t k = 2; k < bucketBegin.size(); ++k)
        bucketBegin[k] += bucketBegin[k - 1];
    std::vector<std::pair<std::int64_t, Side>> sorted(sideCount); // higher vertex and side
    forEachSide([&](Side side, std::int64_t low, std::int64_t high) {
        sorted[bucketBegin[at(low) + 1]++] = {high, side};
    });
    SoupEdges edges;
    edges.sides.reserve(sideCount);
    edges.begin.reserve(sideCount / 2 + 1);
    for (std::size_t k = 0; k < soup.points.size(); ++k) { // each begin has moved to the next one's place
        const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
        const auto begin = at(bucketBegin[k]), end = at(bucketBegin[k + 1]);
        std::sort(begin, end);
        for (auto entry = begin; entry != end; ++entry) {
            if (entry == begin || entry->first != (entry - 1)->first)
                edges.begin.push_back(edges.sides.size());
            edges.sides.push_back(entry->second);
        }
    }
    edges.begin.push_back(sideCount);
    return edges;
}

std::vector<Side> twinSides(const Soup& soup, const SoupEdges& edges) {
    std::vector<Side> twins(soup.corners.size(), static_cast<Side>(soup.corners.size()));
    for (std::size_t k = 0; k < edges.count(); ++k)
        if (const auto sides = edges.edge(k); sides.size() == 2) {
            twins[sides[0]] = sides[1];
            twins[sides[1]] = sides[0];
        }
    return twins;
}

Orientation findOrientation(const Soup& soup, const std::vector<Side>& twins) {
    return findOrientation(
        4, twins, [&](Side side, Side twin) { return sideFrom(soup, side) != sideFrom(soup, twin); });
}

} // namespace qm

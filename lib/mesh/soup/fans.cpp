#include "base/at.h"
#include "mesh/solid_pairs.h"
#include "mesh/soup/soup_repairs.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// From the middle of a side to that of the opposite one.
Point intoQuad(const Soup& soup, Side side) {
    const auto middle = [&](Side of) -> Point {
        return (soup.points[at(sideFrom(soup, of))] + soup.points[at(sideTo(soup, of))]) / 2;
    };
    return middle(nextSide(nextSide(side))) - middle(side);
}

/// An edge of more than two quads.
struct CrowdedEdge {
    std::span<const Side> sides;
    bool isTurned = false; ///< whether pairs bound what is outside of the surface, not what is inside
};

std::vector<CrowdedEdge> crowdedEdges(const SoupEdges& edges) {
    std::vector<CrowdedEdge> crowded;
    for (std::size_t k = 0; k < edges.count(); ++k)
        if (edges.edge(k).size() > 2) crowded.push_back({edges.edge(k)});
    return crowded;
}

/// Pairs the quads at crowded edges, where as many run along the edge one way as the other.
/// \return the vertices of all other crowded edges
std::vector<bool> pairCrowded(const Soup& soup, const std::vector<CrowdedEdge>& edges,
                              std::vector<Side>& twins) {
    std::vector<bool> unpaired(soup.points.size(), false);
    for (const auto& [sides, isTurned] : edges) {
        const std::int64_t from = sideFrom(soup, sides[0]), to = sideTo(soup, sides[0]);
        std::vector<FaceAtEdge> faces;
        for (const Side side : sides)
            faces.push_back({side, (sideFrom(soup, side) == from) != isTurned, intoQuad(soup, side)});
        if (2 * std::ranges::count(faces, true, &FaceAtEdge::ascends) != std::ssize(faces)) {
            unpaired[at(from)] = unpaired[at(to)] = true;
            continue;
        }
        for (const auto& [one, other] :
             pairsAroundSolids(soup.points[at(to)] - soup.points[at(from)], faces)) {
            twins[one] = other;
            twins[other] = one;
        }
    }
    return unpaired;
}

/// Turns the crowded edges at which pairs would still share both ends.
void turnShared(const Soup& soup, const std::vector<Side>& twins, std::vector<CrowdedEdge>& edges) {
    std::vector<std::size_t> fanOf(twins.size());
    std::size_t fans = 0;
    forEachFan(twins, [&](std::span<const Side> corners) {
        for (const Side corner : corners)
            fanOf[corner] = fans;
        ++fans;
    });
    for (auto& [sides, isTurned] : edges) {
        std::vector<std::pair<std::size_t, std::size_t>> ends;
        for (const Side side : sides)
            if (sideFrom(soup, side) == sideFrom(soup, sides[0]))
                ends.emplace_back(fanOf[side], fanOf[nextSide(side)]);
        std::ranges::sort(ends);
        isTurned = std::ranges::adjacent_find(ends) != ends.end();
    }
}

std::size_t copyPoint(Soup& soup, std::size_t point) {
    const std::size_t number = soup.pointNumber(point);
    writeDown(soup.pointNumbers, soup.points.size()); // messages still name the vertex of the file
    soup.pointNumbers.push_back(static_cast<std::uint32_t>(number));
    if (!soup.pointLines.empty()) soup.pointLines.push_back(soup.pointLines[point]);
    soup.points.emplace_back(Point(soup.points[point]));
    return soup.points.size() - 1;
}

} // namespace

void forEachFan(const std::vector<Side>& twins, const std::function<void(std::span<const Side>)>& visit) {
    const auto none = static_cast<Side>(twins.size());
    std::vector<bool> seen(twins.size(), false);
    std::vector<Side> fan;
    const auto walk = [&](Side start) {
        fan.clear();
        // The next corner around the vertex belongs to the quad across this quad's previous side.
        for (Side corner = start; corner != none && !seen[corner]; corner = twins[previousSide(corner)]) {
            seen[corner] = true;
            fan.push_back(corner);
        }
        visit(fan);
    };
    for (Side corner = 0; corner < none; ++corner) // an open fan begins at a side without a twin
        if (twins[corner] == none) walk(corner);
    for (Side corner = 0; corner < none; ++corner)
        if (!seen[corner]) walk(corner);
}

std::size_t splitFans(Soup& soup) {
    const SoupEdges edges = findEdges(soup);
    std::vector<Side> twins = twinSides(soup, edges);
    std::vector<CrowdedEdge> crowded = crowdedEdges(edges);
    std::vector<bool> unpaired = pairCrowded(soup, crowded, twins);
    if (!crowded.empty()) {
        turnShared(soup, twins, crowded);
        unpaired = pairCrowded(soup, crowded, twins);
    }
    enum class Fans : char { none, one, several };
    std::vector<Fans> fans(soup.points.size(), Fans::none);
    std::size_t count = 0;
    forEachFan(twins, [&](std::span<const Side> corners) {
        const std::size_t vertex = at(soup.corners[corners.front()]);
        if (unpaired[vertex]) return;
        if (fans[vertex] == Fans::none) {
            fans[vertex] = Fans::one;
            return;
        }
        if (fans[vertex] == Fans::one) ++count;
        fans[vertex] = Fans::several;
        const auto copy = static_cast<std::int64_t>(copyPoint(soup, vertex));
        for (const Side corner : corners)
            soup.corners[corner] = copy;
    });
    return count;
}

} // namespace qm

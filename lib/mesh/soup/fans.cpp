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

/// Pairs the quads at edges of more than two, where as many run along the edge one way as the other.
/// \param turned  by edge: whether pairs bound what is outside of the surface, not what is inside
/// \return the vertices of all other such edges
std::vector<bool> pairCrowded(const Soup& soup, const SoupEdges& edges, const std::vector<bool>& turned,
                              std::vector<Side>& twins) {
    std::vector<bool> crowded(soup.points.size(), false);
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() <= 2) continue;
        const std::int64_t from = sideFrom(soup, sides[0]), to = sideTo(soup, sides[0]);
        std::vector<FaceAtEdge> faces;
        for (const Side side : sides)
            faces.push_back({side, (sideFrom(soup, side) == from) != turned[k], intoQuad(soup, side)});
        if (2 * std::ranges::count(faces, true, &FaceAtEdge::ascends) != std::ssize(faces)) {
            crowded[at(from)] = crowded[at(to)] = true;
            continue;
        }
        for (const auto& [one, other] :
             pairsAroundSolids(soup.points[at(to)] - soup.points[at(from)], faces)) {
            twins[one] = other;
            twins[other] = one;
        }
    }
    return crowded;
}

/// Turns the edges of more than two quads at which pairs would still share both ends.
void turnShared(const Soup& soup, const SoupEdges& edges, const std::vector<Side>& twins,
                std::vector<bool>& turned) {
    std::vector<std::size_t> fanOf(twins.size());
    std::size_t fans = 0;
    forEachFan(twins, [&](std::span<const Side> corners) {
        for (const Side corner : corners)
            fanOf[corner] = fans;
        ++fans;
    });
    for (std::size_t k = 0; k < edges.count(); ++k) {
        const auto sides = edges.edge(k);
        if (sides.size() <= 2) continue;
        std::vector<std::pair<std::size_t, std::size_t>> ends;
        for (const Side side : sides)
            if (sideFrom(soup, side) == sideFrom(soup, sides[0]))
                ends.emplace_back(fanOf[side], fanOf[nextSide(side)]);
        std::ranges::sort(ends);
        turned[k] = std::ranges::adjacent_find(ends) != ends.end();
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
    std::vector<bool> turned(edges.count(), false);
    (void)pairCrowded(soup, edges, turned, twins);
    turnShared(soup, edges, twins, turned);
    const std::vector<bool> crowded = pairCrowded(soup, edges, turned, twins);
    enum class Fans : char { none, one, several };
    std::vector<Fans> fans(soup.points.size(), Fans::none);
    std::size_t count = 0;
    forEachFan(twins, [&](std::span<const Side> corners) {
        const std::size_t vertex = at(soup.corners[corners.front()]);
        if (crowded[vertex]) return;
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

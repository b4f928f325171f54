#include "base/at.h"
#include "mesh/soup/soup_repairs.h"

namespace qm {
namespace {

/// The vertices of edges at which more than two quads meet.
std::vector<bool> crowdedVertices(const Soup& soup, const SoupEdges& edges) {
    std::vector<bool> crowded(soup.points.size(), false);
    for (std::size_t k = 0; k < edges.count(); ++k)
        if (const auto sides = edges.edge(k); sides.size() > 2)
            for (const std::int64_t vertex : {sideFrom(soup, sides[0]), sideTo(soup, sides[0])})
                crowded[at(vertex)] = true;
    return crowded;
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
    const std::vector<Side> twins = twinSides(soup, edges);
    const std::vector<bool> crowded = crowdedVertices(soup, edges);
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

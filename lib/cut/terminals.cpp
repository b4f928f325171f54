#include "cut/terminals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace qm {
namespace {

std::size_t at(VertexId vertex) {
    return static_cast<std::size_t>(vertex.idx());
}

VertexId nearestTo(const QuadMesh& mesh, const std::vector<VertexId>& vertices, const Point& place) {
    return *std::ranges::min_element(vertices, std::less{},
                                     [&](VertexId vertex) { return (mesh.point(vertex) - place).sqrnorm(); });
}

/// The sources farthest apart: eccentricities are bounded by the triangle inequality until none can beat the
/// best.
std::pair<VertexId, VertexId> farthestSources(const std::vector<VertexId>& sources, Geodesics& geodesics) {
    std::vector<double> upper(sources.size(), std::numeric_limits<double>::infinity());
    std::pair<VertexId, VertexId> best(sources.front(), sources.back());
    double longest = -1;
    std::size_t next = 0;
    for (;;) {
        const auto& distance = geodesics.from(sources[next]);
        std::size_t farthest = next;
        for (std::size_t k = 0; k < sources.size(); ++k)
            if (distance[at(sources[k])] > distance[at(sources[farthest])]) farthest = k;
        const double eccentricity = distance[at(sources[farthest])];
        if (eccentricity > longest) {
            longest = eccentricity;
            best = std::minmax(sources[next], sources[farthest],
                               [](VertexId a, VertexId b) { return a.idx() < b.idx(); });
        }
        for (std::size_t k = 0; k < sources.size(); ++k)
            upper[k] = std::min(upper[k], eccentricity + distance[at(sources[k])]);
        upper[next] = -1;
        next = static_cast<std::size_t>(std::ranges::max_element(upper) - upper.begin());
        // The bound is loose by up to a factor of two: what it can still promise beyond that is not worth a
        // sweep.
        if (upper[next] <= longest * 1.05) return best;
    }
}

std::vector<TerminalPair> irregular(const QuadMesh& mesh, const std::vector<VertexId>& vertices,
                                    const std::vector<VertexId>& sources, Geodesics& geodesics) {
    const auto [p1, p2] = farthestSources(sources, geodesics);
    const std::vector<double> from1 = geodesics.from(p1);
    const std::vector<double>& from2 = geodesics.from(p2);
    Point centre1(0, 0, 0), centre2(0, 0, 0);
    double count1 = 0, count2 = 0;
    for (const VertexId source : sources)
        if (from1[at(source)] <= from2[at(source)]) {
            centre1 += mesh.point(source);
            ++count1;
        } else {
            centre2 += mesh.point(source);
            ++count2;
        }
    if (count2 == 0) return {};
    return {
        {nearestTo(mesh, vertices, centre1 / count1), nearestTo(mesh, vertices, centre2 / count2), p1, p2}};
}

/// Directions spread evenly over half a sphere.
std::vector<Point> directions(int count) {
    std::vector<Point> result;
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int k = 0; k < count; ++k) {
        const double z = (k + 0.5) / count, radius = std::sqrt(1 - z * z);
        result.emplace_back(radius * std::cos(golden * k), radius * std::sin(golden * k), z);
    }
    return result;
}

std::vector<TerminalPair> farthest(const QuadMesh& mesh, const std::vector<VertexId>& vertices) {
    std::vector<VertexId> extremes;
    for (const Point& direction : directions(128)) {
        const auto [low, high] = std::ranges::minmax_element(
            vertices, std::less{}, [&](VertexId vertex) { return mesh.point(vertex) | direction; });
        extremes.push_back(*low);
        extremes.push_back(*high);
    }
    std::pair best(extremes[0], extremes[1]);
    double longest = -1;
    for (std::size_t i = 0; i < extremes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double length = (mesh.point(extremes[i]) - mesh.point(extremes[j])).sqrnorm();
            if (length <= longest) continue;
            longest = length;
            best = {extremes[j], extremes[i]};
        }
    return {{best.first, best.second, best.first, best.second}};
}

std::vector<TerminalPair> box(const QuadMesh& mesh, const std::vector<VertexId>& vertices) {
    Point low = mesh.point(vertices.front()), high = low;
    for (const VertexId vertex : vertices) {
        low.minimize(mesh.point(vertex));
        high.maximize(mesh.point(vertex));
    }
    std::vector<TerminalPair> pairs;
    for (unsigned axis = 0; axis < 3; ++axis) {
        Point lowWall = (low + high) / 2, highWall = lowWall;
        lowWall[axis] = low[axis];
        highWall[axis] = high[axis];
        const VertexId source = nearestTo(mesh, vertices, lowWall),
                       sink = nearestTo(mesh, vertices, highWall);
        pairs.push_back({source, sink, source, sink});
    }
    return pairs;
}

} // namespace

std::vector<TerminalPair> chooseTerminals(const QuadMesh& mesh, const std::vector<VertexId>& vertices,
                                          const std::vector<VertexId>& sources, Terminals kind,
                                          Geodesics& geodesics) {
    if (sources.size() < 2) return {};
    std::vector<TerminalPair> pairs = kind == Terminals::irregular
                                          ? irregular(mesh, vertices, sources, geodesics)
                                      : kind == Terminals::farthest ? farthest(mesh, vertices)
                                                                    : box(mesh, vertices);
    std::erase_if(pairs, [](const TerminalPair& pair) { return pair.source == pair.sink; });
    return pairs;
}

} // namespace qm

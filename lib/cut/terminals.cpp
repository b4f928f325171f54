#include "cut/terminals.h"

#include "base/positions.h"
#include "cut/farthest_pair.h"
#include "mesh/bounding_box.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace qm {
namespace {

VertexId nearestTo(const QuadMesh& mesh, const std::vector<VertexId>& vertices, const Point& place) {
    return *std::ranges::min_element(vertices, std::less{},
                                     [&](VertexId vertex) { return (mesh.point(vertex) - place).sqrnorm(); });
}

VertexId farthestFrom(const QuadMesh& mesh, const std::vector<VertexId>& vertices, VertexId from) {
    return *std::ranges::max_element(vertices, std::less{}, [&](VertexId vertex) {
        return (mesh.point(vertex) - mesh.point(from)).sqrnorm();
    });
}

VertexId centre(const QuadMesh& mesh, const std::vector<VertexId>& vertices,
                const std::vector<VertexId>& group) {
    Point sum(0, 0, 0);
    for (const VertexId vertex : group)
        sum += mesh.point(vertex);
    return nearestTo(mesh, vertices, sum / static_cast<double>(group.size()));
}

std::vector<TerminalPair> irregular(const QuadMesh& mesh, const std::vector<VertexId>& vertices,
                                    const PieceSources& sources, SurfaceDistances& distances) {
    std::vector<VertexId> members = sources.extraordinary;
    if (members.size() < 2) members.insert(members.end(), sources.seeds.begin(), sources.seeds.end());
    if (members.size() < 2) return {};
    const FarthestPair pair = farthestPair(members, distances);
    TerminalPair result;
    for (std::size_t k = 0; k < members.size(); ++k)
        result.groups[pair.fromFirst[k] <= pair.fromSecond[k] ? 0 : 1].push_back(members[k]);
    if (result.groups[1].empty()) return {}; // all members are in one place
    result.source = centre(mesh, vertices, result.groups[0]);
    result.sink = centre(mesh, vertices, result.groups[1]);
    return {std::move(result)};
}

/// Directions spread evenly over a half-sphere.
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
    std::vector<double> heights(vertices.size());
    for (const Point& direction : directions(128)) {
        std::ranges::transform(vertices, heights.begin(),
                               [&](VertexId vertex) { return mesh.point(vertex) | direction; });
        for (const auto extreme : {std::ranges::min_element(heights), std::ranges::max_element(heights)})
            extremes.push_back(vertices[positionIn(heights, extreme)]);
    }
    const auto distance = [&](VertexId a, VertexId b) { return (mesh.point(a) - mesh.point(b)).sqrnorm(); };
    VertexId a = vertices.front(), b = a;
    for (const VertexId first : extremes)
        for (const VertexId second : extremes)
            if (distance(first, second) > distance(a, b)) {
                a = first;
                b = second;
            }
    // The directions may miss a pair, so the search goes on until each end is the farthest vertex from the
    // other.
    for (int settled = 0; settled < 2; std::swap(a, b)) {
        const VertexId c = farthestFrom(mesh, vertices, a);
        const bool farther = distance(a, c) > distance(a, b);
        if (farther) b = c;
        settled = farther ? 1 : settled + 1;
    }
    if (b.idx() < a.idx()) std::swap(a, b);
    return {{a, b, {}}};
}

std::vector<TerminalPair> betweenWalls(const QuadMesh& mesh, const std::vector<VertexId>& vertices) {
    const BoundingBox box = boundingBoxOf(vertices, [&](VertexId vertex) { return mesh.point(vertex); });
    std::vector<TerminalPair> pairs;
    for (unsigned axis = 0; axis < 3; ++axis) {
        Point lowWall = box.centre(), highWall = lowWall;
        lowWall[axis] = box.low[axis];
        highWall[axis] = box.high[axis];
        pairs.push_back({nearestTo(mesh, vertices, lowWall), nearestTo(mesh, vertices, highWall), {}});
    }
    return pairs;
}

} // namespace

std::vector<TerminalPair> chooseTerminals(const QuadMesh& mesh, const std::vector<VertexId>& vertices,
                                          const PieceSources& sources, Terminals kind,
                                          SurfaceDistances& distances) {
    std::vector<TerminalPair> pairs;
    if (kind == Terminals::irregular)
        pairs = irregular(mesh, vertices, sources, distances);
    else if (kind == Terminals::farthest)
        pairs = farthest(mesh, vertices);
    else
        pairs = betweenWalls(mesh, vertices);
    std::erase_if(pairs, [](const TerminalPair& pair) { return pair.source == pair.sink; });
    return pairs;
}

} // namespace qm

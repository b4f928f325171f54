#include "mesh/triangles/triangle_edges.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/groups.h"

#include <algorithm>
#include <utility>

namespace qm {

void forEachEdge(const Triangles& triangles,
                 const std::function<void(std::span<const TriangleSide>)>& visit) {
    std::vector<TriangleSide> sides;
    sides.reserve(3 * triangles.faces.size());
    for (const auto& face : triangles.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = face[k], to = face[(k + 1) % 3];
            sides.push_back(
                {std::min(from, to), std::max(from, to), from < to, static_cast<Side>(sides.size())});
        }
    std::ranges::sort(sides);
    forEachGroup(
        sides, [](const TriangleSide& side) { return std::pair(side.low, side.high); }, visit);
}

BoundarySides boundarySides(const Triangles& triangles) {
    BoundarySides boundary{std::vector<bool>(3 * triangles.faces.size()),
                           std::vector<bool>(triangles.points.size())};
    forEachEdge(triangles, [&](std::span<const TriangleSide> edge) {
        if (edge.size() != 1) return;
        boundary.sides[edge[0].side] = true;
        boundary.points[at(edge[0].low)] = boundary.points[at(edge[0].high)] = true;
    });
    return boundary;
}

std::size_t boundaryLoopCount(const Triangles& triangles) {
    DisjointSets sets(triangles.points.size());
    std::vector<bool> isOnBoundary(triangles.points.size(), false);
    forEachEdge(triangles, [&](std::span<const TriangleSide> edge) {
        if (edge.size() != 1) return;
        sets.join(at(edge[0].low), at(edge[0].high));
        isOnBoundary[at(edge[0].low)] = isOnBoundary[at(edge[0].high)] = true;
    });
    std::size_t loops = 0;
    for (std::size_t k = 0; k < isOnBoundary.size(); ++k)
        if (isOnBoundary[k] && sets.find(k) == k) ++loops;
    return loops;
}

} // namespace qm

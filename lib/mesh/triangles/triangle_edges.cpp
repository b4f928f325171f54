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
    const auto [sides, points] = boundarySides(triangles);
    DisjointSets sets(points.size());
    for (std::size_t side = 0; side < sides.size(); ++side)
        if (const auto& face = triangles.faces[side / 3]; sides[side])
            sets.join(at(face[side % 3]), at(face[(side + 1) % 3]));
    std::size_t loops = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (points[k] && sets.find(k) == k) ++loops;
    return loops;
}

} // namespace qm

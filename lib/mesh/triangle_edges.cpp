#include "mesh/triangle_edges.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/error.h"
#include "base/number_text.h"

#include <algorithm>
#include <compare>
#include <span>

namespace qm {
namespace {

/// A side of a triangle, with the lower of its two points first.
struct TriangleSide {
    int low = 0;
    int high = 0;
    bool ascends = false;
    // NOLINTNEXTLINE(modernize-use-nullptr): the compiler generates this 0
    auto operator<=>(const TriangleSide&) const = default;
    [[nodiscard]] bool sameEdge(const TriangleSide& other) const {
        return low == other.low && high == other.high;
    }
};

std::vector<TriangleSide> sortedSides(const Triangles& triangles) {
    std::vector<TriangleSide> sides;
    sides.reserve(3 * triangles.faces.size());
    for (const auto& face : triangles.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = face[k], to = face[(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    std::ranges::sort(sides);
    return sides;
}

std::string placeOf(const Triangles& triangles, const TriangleSide& side) {
    const Point middle = (triangles.points[at(side.low)] + triangles.points[at(side.high)]) / 2;
    return "at (" + roundedText(middle[0]) + ", " + roundedText(middle[1]) + ", " + roundedText(middle[2]) +
           ")";
}

/// The first edge with a certain fault, and the number of such edges.
struct Fault {
    TriangleSide first;
    std::size_t sides = 0;
    std::size_t edges = 0;

    void add(std::span<const TriangleSide> edge) {
        if (edges++ == 0) {
            first = edge.front();
            sides = edge.size();
        }
    }
};

/// Counts the connected components of a set of edges.
class EdgeParts {
public:
    explicit EdgeParts(std::size_t points) : sets_(points), used_(points, false) {}
    void join(int a, int b) {
        sets_.join(at(a), at(b));
        used_[at(a)] = used_[at(b)] = true;
    }
    [[nodiscard]] std::size_t count() {
        std::size_t parts = 0;
        for (std::size_t k = 0; k < used_.size(); ++k)
            if (used_[k] && sets_.find(k) == k) ++parts;
        return parts;
    }

private:
    DisjointSets sets_;
    std::vector<bool> used_;
};

} // namespace

std::size_t validateTriangleEdges(const Triangles& triangles) {
    const std::vector<TriangleSide> sides = sortedSides(triangles);
    EdgeParts boundary(triangles.points.size());
    Fault crowded, turned;
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end = std::find_if(begin, sides.end(),
                                      [&](const TriangleSide& side) { return !side.sameEdge(*begin); });
        const std::span<const TriangleSide> edge(begin, end);
        if (edge.size() == 1) boundary.join(edge[0].low, edge[0].high);
        if (edge.size() > 2) crowded.add(edge);
        if (edge.size() == 2 && edge[0].ascends == edge[1].ascends) turned.add(edge);
        begin = end;
    }
    if (crowded.edges > 0)
        throw Error(placeOf(triangles, crowded.first),
                    std::to_string(crowded.sides) + " triangles meet at an edge, and more than two at " +
                        std::to_string(crowded.edges) + " in all, so the surface is no manifold",
                    "Take the extra triangles out");
    if (turned.edges > 0)
        throw Error(placeOf(triangles, turned.first),
                    "two neighbours are oriented inconsistently, as at " + std::to_string(turned.edges) +
                        " edges in all",
                    "Turn normals to one side, as every program for meshes can");
    return boundary.count();
}

} // namespace qm

#include "base/at.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/positions.h"
#include "mesh/orientation.h"
#include "mesh/triangles/repair_triangles.h"
#include "mesh/triangles/triangle_edges.h"

#include <span>
#include <utility>
#include <vector>

namespace qm {

std::size_t orientTriangles(Triangles& triangles) {
    const auto sideCount = static_cast<Side>(3 * triangles.faces.size());
    std::vector<Side> twins(sideCount, sideCount);
    forEachEdge(triangles, [&](std::span<const TriangleSide> edge) {
        if (edge.size() != 2) return;
        twins[edge[0].side] = edge[1].side;
        twins[edge[1].side] = edge[0].side;
    });
    const auto from = [&](Side side) { return triangles.faces[side / 3][side % 3]; };
    const Orientation orientation =
        findOrientation(3, twins, [&](Side side, Side twin) { return from(side) != from(twin); });
    if (orientation.contradiction) {
        const auto& [a, b, c] = triangles.faces[*orientation.contradiction];
        const Point middle =
            (triangles.points[at(a)] + triangles.points[at(b)] + triangles.points[at(c)]) / 3;
        throw Error("at (" + roundedText(middle[0]) + ", " + roundedText(middle[1]) + ", " +
                        roundedText(middle[2]) + ")",
                    "a triangle cannot be oriented as all its neighbours are: the surface has one side only, "
                    "like a Moebius strip",
                    "Cut it open");
    }
    for (std::size_t face = 0; face < triangles.faces.size(); ++face)
        if (orientation.reversed[face]) std::swap(triangles.faces[face][1], triangles.faces[face][2]);
    return countIn(orientation.reversed, true);
}

} // namespace qm

/// \file Which patches meet at which edge of the layout.
#pragma once

#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// An edge as one patch sees it: edge number `position` of its side `side`, walked counter-clockwise.
struct BorderPlace {
    std::size_t patch = 0;
    int side = 0;
    int position = 0;
};

/// A mesh edge on the border of segments. The second place, if there is one, sees it the other way round; it
/// may belong to the same patch. On the boundary of the mesh there is only one.
struct BorderEdge {
    HalfedgeId halfedge; ///< in the direction of the first place
    std::vector<BorderPlace> places;
};

/// All border edges, in the order of the first segment, side and position that has them.
[[nodiscard]] std::vector<BorderEdge> borderEdges(const QuadMesh& mesh, const Layout& layout);

/// The parameters (u, v) at distance `along` from the beginning of a side.
[[nodiscard]] std::array<double, 2> parametersOnSide(const std::array<int, 2>& size, int side, double along);

/// Whether the parameter that runs across a side ends there, and does not begin.
constexpr bool isFarSide(int side) {
    return side == 1 || side == 2;
}

/// The side at which u (0) or v (1) begins, or ends if it `isFar`.
constexpr int sideAcross(std::size_t direction, bool isFar) {
    return direction == 0 ? (isFar ? 1 : 3) : (isFar ? 2 : 0);
}

/// The number of point `k` of a side, in the order of u or v, on a lattice of so many columns and rows.
constexpr std::size_t pointOnSide(std::size_t columns, std::size_t rows, int side, std::size_t k) {
    return side % 2 == 0 ? (isFarSide(side) ? rows - 1 : 0) * columns + k
                         : k * columns + (isFarSide(side) ? columns - 1 : 0);
}

} // namespace qm

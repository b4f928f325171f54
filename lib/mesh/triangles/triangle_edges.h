/// \file The edges of a surface of triangles.
#pragma once

#include "mesh/orientation.h"
#include "mesh/triangles/triangles.h"

#include <compare>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace qm {

/// A side of a triangle, with the lower of its two points first.
struct TriangleSide {
    int low = 0;
    int high = 0;
    bool ascends = false; ///< whether the triangle runs from the lower to the higher point
    Side side = 0;        ///< 3 * f + k of triangle f
    // NOLINTNEXTLINE(modernize-use-nullptr): the compiler generates this 0
    auto operator<=>(const TriangleSide&) const = default;
};

/// Calls `visit` once for every edge, with all sides there. Takes n log n time.
void forEachEdge(const Triangles& triangles, const std::function<void(std::span<const TriangleSide>)>& visit);

struct BoundarySides {
    std::vector<bool> sides;  ///< by side: whether no other triangle has its edge
    std::vector<bool> points; ///< by point: whether such a side begins or ends there
};

/// Takes n log n time.
[[nodiscard]] BoundarySides boundarySides(const Triangles& triangles);

/// \param triangles  at most two at every edge
/// \return the number of boundary loops; loops that touch count as one
[[nodiscard]] std::size_t boundaryLoopCount(const Triangles& triangles);

} // namespace qm

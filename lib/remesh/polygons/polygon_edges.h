/// \file The edges of a surface of polygons, and which of them are sharp.
#pragma once

#include "mesh/soup/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace qm {

/// Edges in the order in which the polygons first use them. A polygon's corner k stands for the side from it
/// to the next corner.
struct PolygonEdges {
    std::vector<std::size_t> edgeOf;               ///< by corner: the edge of its side
    std::vector<std::array<std::int64_t, 2>> ends; ///< by edge: its vertices, the lower one first
    std::vector<bool> isSharp;                     ///< by edge
};

/// Sharp edges are those of one polygon, of more than two, of two that are oriented differently, and those
/// whose dihedral angle is above a limit. A polygon's normal is that of the area that it encloses; a polygon
/// without area makes no edge sharp.
/// \param soup  polygons with indices in range
/// \param rho  the limit, radians
[[nodiscard]] PolygonEdges polygonEdges(const Soup& soup, double rho);

/// Twice the area of a polygon, seen along its normal, times the unit normal; zero where neither exists.
[[nodiscard]] Point areaVector(const Soup& soup, std::size_t face);

} // namespace qm

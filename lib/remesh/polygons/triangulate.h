/// \file Dividing a polygon in the plane into triangles.
#pragma once

#include "remesh/polygons/planar_polygon.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace qm {

/// Three corners of a polygon, counterclockwise.
using Corners = std::array<std::size_t, 3>;

/// Cuts ears off a polygon, the best first, and turns sides as long as that makes the smallest angles larger
/// ([Lawson 1977](docs/METHOD.md#lawson-1977)). Takes time proportional to corners times reflex corners, but
/// for combs.
/// \param mayConnect  whether a side between two corners may be added
/// \return none where the polygon crosses itself, or has more than 1,000 corners
[[nodiscard]] std::vector<Corners>
triangulate(const std::vector<PlanarPoint>& corners,
            const std::function<bool(std::size_t, std::size_t)>& mayConnect);

/// A side that is shared by two triangles.
struct Diagonal {
    std::array<std::size_t, 2> triangles;
    std::array<std::size_t, 4> quad; ///< both together; the diagonal goes from its first corner to the third
};

[[nodiscard]] std::vector<Diagonal> diagonalsOf(const std::vector<Corners>& triangles);

/// The corners of such a quad in the plane.
[[nodiscard]] std::vector<PlanarPoint> placesOf(const std::vector<PlanarPoint>& corners,
                                                const std::array<std::size_t, 4>& quad);

} // namespace qm

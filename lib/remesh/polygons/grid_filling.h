/// \file Filling a polygon of many corners with a ring of quads around a grid.
#pragma once

#include "remesh/polygons/planar_polygon.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// Quads that fill a closed line, the rim.
struct GridFilling {
    std::size_t innerPoints = 0;
    std::vector<std::array<std::size_t, 4>> quads; ///< of points of the rim, and behind them inner ones
};

/// Whether a polygon should be filled so, and not be divided around its middle: it has at least 8 corners and
/// at most 128, is convex, and turns at some corner by at most 30 degrees, where only one quad would be.
[[nodiscard]] bool needsGrid(const std::vector<PlanarPoint>& corners);

/// A ring of quads along the rim, so that two meet at each of its points, and inside a grid, the four corners
/// of which are the only irregular vertices. They lie where the polygon turns most.
/// \param corners  of the polygon; the rim has a further point between every two of them
[[nodiscard]] GridFilling gridFilling(const std::vector<PlanarPoint>& corners);

/// Puts every inner point in the middle of its neighbours ([Tutte 1963](docs/METHOD.md#tutte-1963)).
/// \return the inner points
[[nodiscard]] std::vector<Point> innerPoints(const GridFilling& filling, const std::vector<Point>& rim);

} // namespace qm

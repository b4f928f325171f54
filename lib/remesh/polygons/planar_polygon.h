/// \file A polygon in its plane.
#pragma once

#include "mesh/soup/soup.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {

using PlanarPoint = OpenMesh::Vec2d;

/// Twice the area of the triangle from the origin to a and b; positive if it is counterclockwise.
[[nodiscard]] inline double cross(const PlanarPoint& a, const PlanarPoint& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// By how much the way from a over b to c turns to the left, radians.
[[nodiscard]] inline double turn(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
    return std::atan2(cross(b - a, c - b), (b - a) | (c - b));
}

/// The turns of a polygon at its corners.
[[nodiscard]] std::vector<double> turnsOf(const std::vector<PlanarPoint>& corners);

/// The corners of a polygon, seen along its normal, counterclockwise; all in one point where it has no area.
[[nodiscard]] std::vector<PlanarPoint> planarCorners(const Soup& soup, std::size_t face);

/// A corner that turns by less than this lies in the middle of a side, unless those of a regular polygon of
/// as many corners turned by no more than four times as much; radians.
constexpr double straightTurn = 0.1745;

/// Whether all corners turn to the left, and none lies in the middle of a side.
[[nodiscard]] bool isConvex(const std::vector<PlanarPoint>& corners);

/// Whether it is convex and can be divided into quads around the mean of its corners: from there, the middles
/// of two successive sides are always less than half a turn apart.
[[nodiscard]] bool isSeenFromItsMiddle(const std::vector<PlanarPoint>& corners);

} // namespace qm

/// \file Angles between vectors, precise also near 0 and pi, where an arc cosine is not.
#pragma once

#include "mesh/quad_mesh.h"

#include <cmath>
#include <numbers>

namespace qm {

/// The angle between two vectors of any length in radians, 0 to pi; 0 if one of them is zero.
[[nodiscard]] inline double angleBetween(const Point& a, const Point& b) {
    return std::atan2((a % b).norm(), (a | b) + 0.0); // -0 would be half a turn
}

/// The same in degrees.
[[nodiscard]] inline double degreesBetween(const Point& a, const Point& b) {
    return angleBetween(a, b) * 180 / std::numbers::pi;
}

} // namespace qm

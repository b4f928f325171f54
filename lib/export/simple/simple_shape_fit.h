/// \file Least-squares fits of planes, cylinders, cones, spheres and tori to points with normals, and the
/// guesses that they start from (simple_shape_guess.cpp).
#pragma once

#include "export/simple/simple_shape.h"

#include <optional>

namespace qm {

/// A surface of a kind near the points, from linear equations that points and normals of such surfaces
/// fulfil. A plane is the nearest one; other kinds are starting values for an iteration, and their numbers
/// may be invalid.
/// \param cloud  at least ten points; four of a plane, whose normals are ignored
[[nodiscard]] SimpleShape guessShape(SimpleKind kind, const OrientedPoints& cloud);

/// The surface of a kind with the smallest sum of squared distances from the points; none if their normals do
/// not indicate one.
/// \param cloud  likewise
[[nodiscard]] std::optional<SimpleShape> fitShape(SimpleKind kind, const OrientedPoints& cloud);

} // namespace qm

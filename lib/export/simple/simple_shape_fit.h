/// \file Least-squares fits of planes, cylinders, cones, spheres and tori to points with normals.
#pragma once

#include "export/simple/simple_shape_guess.h"

#include <optional>

namespace qm {

/// The surface of a kind with the smallest sum of squared distances from the points; none if their normals do
/// not indicate one.
/// \param cloud  at least ten points; four of a plane, whose normals are ignored
[[nodiscard]] std::optional<SimpleShape> fitShape(SimpleKind kind, const OrientedPoints& cloud);

} // namespace qm

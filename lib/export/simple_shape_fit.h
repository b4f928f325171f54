/// \file Planes, cylinders, cones, spheres and tori through points with normals, by least squares.
#pragma once

#include "export/simple_shape_guess.h"

#include <optional>

namespace qm {

/// The surface of that kind nearest to the points (sum of squared distances); none if their normals do not
/// point to one.
/// \param cloud  at least ten points
[[nodiscard]] std::optional<SimpleShape> fitShape(SimpleKind kind, const OrientedPoints& cloud);

} // namespace qm

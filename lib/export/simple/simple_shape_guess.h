/// \file Initial guesses of planes, cylinders, cones, spheres and tori from points with normals, by linear
/// equations.
#pragma once

#include "export/simple/simple_shape.h"

#include <Eigen/Core>

#include <vector>

namespace qm {

/// Points of a surface about the origin, of about unit size, and the unit normals there.
struct OrientedPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals;
};

/// A surface of a kind near the points, from linear equations that points and normals of such surfaces
/// fulfil. A plane is the nearest one; other kinds are starting values for an iteration, and their numbers
/// may be invalid.
/// \param cloud  at least ten points; four of a plane, whose normals are ignored
[[nodiscard]] SimpleShape guessShape(SimpleKind kind, const OrientedPoints& cloud);

} // namespace qm

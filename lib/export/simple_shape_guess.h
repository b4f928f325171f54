/// \file Planes, cylinders, cones, spheres and tori near points with normals, off equations that are linear.
#pragma once

#include "export/simple_shape.h"

#include <Eigen/Core>

#include <vector>

namespace qm {

/// Points of a surface about the origin, of about unit size, and the unit normals there.
struct OrientedPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals;
};

/// The surface of a kind that is nearest in the sense of an equation that its points and normals obey. Of a
/// plane, the nearest; of other kinds a place to begin at, whose numbers may be unsound.
/// \param cloud  at least ten points
[[nodiscard]] SimpleShape guessShape(SimpleKind kind, const OrientedPoints& cloud);

} // namespace qm

/// \file Planes, cylinders, cones, spheres and tori by their defining numbers.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace qm {

enum class SimpleKind { plane, cylinder, cone, sphere, torus };

/// One of these surfaces. Members that its kind does not need are ignored.
struct SimpleShape {
    SimpleKind kind = SimpleKind::plane;
    /// A point of the plane or axis; the apex of a cone; otherwise the centre.
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Vector3d axis{0, 0, 1}; ///< unit; the plane's normal; a cone opens towards it
    double radius = 0;             ///< of a torus: of the circle around which its tube runs
    double halfAngle = 0;          ///< of a cone: between axis and surface, in radians
    double tubeRadius = 0;         ///< of a torus

    /// Signed; positive outside.
    [[nodiscard]] double distance(const Eigen::Vector3d& point) const;
    /// Unit, outwards.
    [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector3d& point) const;
    /// From the axis, or a sphere's centre, towards the point; of any length.
    [[nodiscard]] Eigen::Vector3d radial(const Eigen::Vector3d& point) const;
};

/// Points of a surface about the origin, of about unit size, and the unit normals there.
struct OrientedPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals;
};

/// A shape among points that were moved by -centre and then divided by a size, where it was before; and back.
[[nodiscard]] SimpleShape fromFrame(SimpleShape shape, const Eigen::Vector3d& centre, double size);
[[nodiscard]] SimpleShape intoFrame(SimpleShape shape, const Eigen::Vector3d& centre, double size);

} // namespace qm

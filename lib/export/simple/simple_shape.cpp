#include "export/simple/simple_shape.h"

#include <Eigen/Geometry>

#include <cmath>

namespace qm {

double SimpleShape::distance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = point - origin;
    const double height = axis.dot(from);
    const double away = (from - axis * height).norm();
    switch (kind) {
    case SimpleKind::plane:
        return height;
    case SimpleKind::cylinder:
        return away - radius;
    case SimpleKind::cone:
        return away * std::cos(halfAngle) - height * std::sin(halfAngle);
    case SimpleKind::sphere:
        return from.norm() - radius;
    default:
        return std::hypot(away - radius, height) - tubeRadius;
    }
}

Eigen::Vector3d SimpleShape::radial(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = point - origin;
    return kind == SimpleKind::sphere ? from : from - axis * axis.dot(from);
}

Eigen::Vector3d SimpleShape::normal(const Eigen::Vector3d& point) const {
    Eigen::Vector3d out = radial(point).normalized();
    switch (kind) {
    case SimpleKind::plane:
        return axis;
    case SimpleKind::cone:
        return out * std::cos(halfAngle) - axis * std::sin(halfAngle);
    case SimpleKind::torus:
        return (point - origin - out * radius).normalized();
    default:
        return out;
    }
}

SimpleShape fromFrame(SimpleShape shape, const Eigen::Vector3d& centre, double size) {
    shape.origin = centre + shape.origin * size;
    shape.radius *= size;
    shape.tubeRadius *= size;
    return shape;
}

SimpleShape intoFrame(SimpleShape shape, const Eigen::Vector3d& centre, double size) {
    shape.origin = (shape.origin - centre) / size;
    shape.radius /= size;
    shape.tubeRadius /= size;
    return shape;
}

} // namespace qm

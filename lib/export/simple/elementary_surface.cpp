#include "export/simple/elementary_surface.h"

#include <Eigen/Dense>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace qm {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

struct Tuning {
    /// Largest radius, in sizes of the patch: larger arcs look flat, and where their axes lie depends on
    /// rounding errors.
    static constexpr double maxRadius = 10;
    /// Smallest angle between patch and seam, so that no edge touches the seam.
    static constexpr double seamMargin = 2 * degree;
    /// Smallest angle between patch and a sphere's poles, where parameters run together.
    static constexpr double poleMargin = 15 * degree;
    /// Smallest length of the mean of the radial directions: if they all but cancel, the patch goes around,
    /// and no side is free for the seam.
    static constexpr double minMean = 1e-3;
    /// Smallest part of an axis across the direction to the patch: with less, another one serves better.
    static constexpr double minAcross = 0.1;
    /// Smallest distance between patch and a cone's apex, in sizes of the patch.
    static constexpr double apexMargin = 1e-3;
};

gp_Pnt toGp(const Vector3d& v) {
    return {v[0], v[1], v[2]};
}

gp_Dir direction(const Vector3d& v) {
    return {v[0], v[1], v[2]};
}

/// Axes whose seam is on the other side of the points, seen from the shape; none if they reach it.
std::optional<gp_Ax3> axesFor(SimpleShape& shape, const PatchCloud& cloud) {
    Vector3d middle(0, 0, 0);
    for (const Vector3d& point : cloud.samples.points)
        middle += shape.radial(point).normalized();
    if (middle.norm() < Tuning::minMean * static_cast<double>(cloud.samples.points.size()))
        return std::nullopt;
    middle.normalize();
    if (shape.kind == SimpleKind::sphere) {
        const Vector3d across = shape.axis - middle * middle.dot(shape.axis);
        shape.axis = across.norm() > Tuning::minAcross ? across.normalized() : middle.unitOrthogonal();
    }
    const Vector3d across = shape.axis.cross(middle);
    for (const Vector3d& point : cloud.samples.points) {
        const Vector3d out = shape.radial(point).normalized();
        if (std::abs(std::atan2(out.dot(across), out.dot(middle))) > std::numbers::pi - Tuning::seamMargin)
            return std::nullopt;
        if (shape.kind == SimpleKind::sphere && std::abs(out.dot(shape.axis)) > std::cos(Tuning::poleMargin))
            return std::nullopt;
    }
    return gp_Ax3(toGp(cloud.centre + shape.origin * cloud.size), direction(shape.axis), direction(-middle));
}

Handle(Geom_ElementarySurface) cone(const SimpleShape& shape, gp_Ax3 axes, const PatchCloud& cloud) {
    double near = Tuning::maxRadius;
    for (const Vector3d& point : cloud.samples.points)
        near = std::min(near, shape.axis.dot(point - shape.origin));
    if (near < Tuning::apexMargin) return nullptr;
    axes.SetLocation(toGp(cloud.centre + (shape.origin + shape.axis * near) * cloud.size));
    return new Geom_ConicalSurface(axes, shape.halfAngle, near * std::tan(shape.halfAngle) * cloud.size);
}

} // namespace

Handle(Geom_ElementarySurface) elementarySurface(SimpleShape shape, const PatchCloud& cloud) {
    if (shape.kind == SimpleKind::plane)
        return new Geom_Plane(toGp(cloud.centre + shape.origin * cloud.size), direction(shape.axis));
    const auto axes = axesFor(shape, cloud);
    if (!axes || shape.radius > Tuning::maxRadius || shape.tubeRadius > Tuning::maxRadius) return nullptr;
    switch (shape.kind) {
    case SimpleKind::cylinder:
        return new Geom_CylindricalSurface(*axes, shape.radius * cloud.size);
    case SimpleKind::cone:
        return cone(shape, *axes, cloud);
    case SimpleKind::sphere:
        return new Geom_SphericalSurface(*axes, shape.radius * cloud.size);
    default:
        return new Geom_ToroidalSurface(*axes, shape.radius * cloud.size, shape.tubeRadius * cloud.size);
    }
}

} // namespace qm

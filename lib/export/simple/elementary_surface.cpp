#include "export/simple/elementary_surface.h"

#include "export/simple/shape_agreement.h"
#include "export/simple/small_matrices.h"

#include <Eigen/Dense>

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace qm {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

struct Tuning {
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

/// From the shape's centre or axis to the middle of the points; none if these go around.
std::optional<Vector3d> middleOf(const SimpleShape& shape, const OrientedPoints& samples) {
    Vector3d middle(0, 0, 0);
    for (const Vector3d& point : samples.points)
        middle += shape.radial(point).normalized();
    if (middle.norm() < Tuning::minMean * static_cast<double>(samples.points.size())) return std::nullopt;
    return middle.normalized();
}

/// Whether no point is near the seam, which is opposite to the middle, or near a pole.
bool isFree(const SimpleShape& shape, const Vector3d& middle, const OrientedPoints& samples) {
    const Vector3d across = shape.axis.cross(middle);
    return std::ranges::all_of(samples.points, [&](const Vector3d& point) {
        const Vector3d out = shape.radial(point).normalized();
        return std::abs(std::atan2(out.dot(across), out.dot(middle))) <=
                   std::numbers::pi - Tuning::seamMargin &&
               (shape.kind != SimpleKind::sphere ||
                std::abs(out.dot(shape.axis)) <= std::cos(Tuning::poleMargin));
    });
}

/// Axes of a sphere for a patch: the given one, as far as it is at right angles to the middle, and that
/// across a long patch.
std::array<Vector3d, 2> sphereAxes(const SimpleShape& sphere, const Vector3d& middle,
                                   const OrientedPoints& samples) {
    const Vector3d across = sphere.axis - middle * middle.dot(sphere.axis);
    Eigen::Matrix3d spread = middle * middle.transpose() * static_cast<double>(samples.points.size());
    for (const Vector3d& point : samples.points) {
        const Vector3d out = sphere.radial(point).normalized();
        const Vector3d beside = out - middle * middle.dot(out);
        spread += beside * beside.transpose();
    }
    const Vector3d narrow = minEigenvector(spread);
    return {across.norm() > Tuning::minAcross ? across.normalized() : middle.unitOrthogonal(),
            (narrow - middle * middle.dot(narrow)).normalized()};
}

/// Axes whose seam is on the other side of the points, seen from the shape; none if they reach it.
std::optional<gp_Ax3> axesFor(SimpleShape& shape, const PatchCloud& cloud) {
    const auto middle = middleOf(shape, cloud.samples);
    if (!middle) return std::nullopt;
    if (shape.kind == SimpleKind::sphere)
        for (const Vector3d& axis : sphereAxes(shape, *middle, cloud.samples)) {
            shape.axis = axis;
            if (isFree(shape, *middle, cloud.samples)) break;
        }
    if (!isFree(shape, *middle, cloud.samples)) return std::nullopt;
    return gp_Ax3(toGp(cloud.centre + shape.origin * cloud.size), direction(shape.axis), direction(-*middle));
}

Handle(Geom_ElementarySurface) cone(const SimpleShape& shape, gp_Ax3 axes, const PatchCloud& cloud) {
    double near = maxRadius;
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
    if (!axes || shape.radius > maxRadius || shape.tubeRadius > maxRadius) return nullptr;
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

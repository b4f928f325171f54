#include "export/simple_surface.h"

#include "bspline/splines/evaluate.h"
#include "export/simple_shape_fit.h"

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
#include <vector>

namespace qm {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;
/// When a patch is taken for a simple surface.
struct Tuning {
    /// Between a patch's normals and those of what takes its place: more would show as an edge.
    static constexpr double maxNormalAngle = 3 * degree;
    /// In sizes of the patch: arcs of a larger radius are flat to the eye, and their axes are chance.
    static constexpr double maxRadius = 10;
    /// Between patch and seam, so that no edge touches the seam.
    static constexpr double seamMargin = 2 * degree;
    /// Between patch and a sphere's poles, where parameters run together.
    static constexpr double poleMargin = 15 * degree;
    /// Samples of every knot interval: one more than the degree.
    static constexpr int samplesPerInterval = 4;
};

Vector3d vector(const Point& point) {
    return {point[0], point[1], point[2]};
}

/// Points and normals of a patch, moved and scaled to unit size about the origin.
struct Cloud {
    Vector3d centre{0, 0, 0};
    double size = 1;
    OrientedPoints samples;
};

/// Parameters in every knot interval, at both its ends and between.
std::vector<double> parameters(const std::vector<double>& knots, int steps) {
    std::vector<double> result{knots.front()};
    for (std::size_t k = 0; k + 1 < knots.size(); ++k)
        for (int step = 1; step <= steps && knots[k] < knots[k + 1]; ++step)
            result.push_back(knots[k] + (knots[k + 1] - knots[k]) * step / steps);
    return result;
}

/// Every so many of them that about `max` are left, the ends among them.
std::vector<double> thinned(const std::vector<double>& values, std::size_t max) {
    if (values.size() <= max) return values;
    std::vector<double> result;
    for (std::size_t k = 0; k < max; ++k)
        result.push_back(values[k * (values.size() - 1) / (max - 1)]);
    return result;
}

Cloud cloudOf(const Patch& patch, std::size_t max) {
    Cloud cloud;
    Vector3d low = vector(patch.controlPoints.front());
    Vector3d high = low;
    for (const Point& point : patch.controlPoints) {
        low = low.cwiseMin(vector(point));
        high = high.cwiseMax(vector(point));
    }
    cloud.centre = (low + high) / 2;
    cloud.size = (high - low).norm();
    if (!(cloud.size > 0)) return cloud;
    for (const SurfacePoint& at :
         evaluateLattice(patch, thinned(parameters(patch.knots[0], Tuning::samplesPerInterval), max),
                         thinned(parameters(patch.knots[1], Tuning::samplesPerInterval), max))) {
        const Point normal = unitNormal(at.du, at.dv);
        if (normal.sqrnorm() == 0) continue;
        cloud.samples.points.emplace_back((vector(at.position) - cloud.centre) / cloud.size);
        cloud.samples.normals.push_back(vector(normal));
    }
    return cloud;
}

/// Whether the shape lies along the points, on one and the same side of them.
/// \return 1, or -1 if its normals point the other way, or 0
int agreement(const SimpleShape& shape, const OrientedPoints& samples, double tolerance) {
    const double limit = std::cos(Tuning::maxNormalAngle);
    const int side = shape.normal(samples.points.front()).dot(samples.normals.front()) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < samples.points.size(); ++k)
        if (std::abs(shape.distance(samples.points[k])) > tolerance ||
            side * shape.normal(samples.points[k]).dot(samples.normals[k]) < limit)
            return 0;
    return side;
}

gp_Pnt place(const Vector3d& v) {
    return {v[0], v[1], v[2]};
}

gp_Dir direction(const Vector3d& v) {
    return {v[0], v[1], v[2]};
}

/// Axes whose seam is on the other side of the points, seen from the shape; none if they reach it.
std::optional<gp_Ax3> axesFor(SimpleShape& shape, const Cloud& cloud) {
    Vector3d middle(0, 0, 0);
    for (const Vector3d& point : cloud.samples.points)
        middle += shape.radial(point).normalized();
    if (middle.norm() < 1e-3 * static_cast<double>(cloud.samples.points.size())) return std::nullopt;
    middle.normalize();
    if (shape.kind == SimpleKind::sphere)
        shape.axis = (shape.axis - middle * middle.dot(shape.axis)).norm() > 0.1
                         ? (shape.axis - middle * middle.dot(shape.axis)).normalized()
                         : middle.unitOrthogonal();
    const Vector3d across = shape.axis.cross(middle);
    for (const Vector3d& point : cloud.samples.points) {
        const Vector3d out = shape.radial(point).normalized();
        if (std::abs(std::atan2(out.dot(across), out.dot(middle))) > std::numbers::pi - Tuning::seamMargin)
            return std::nullopt;
        if (shape.kind == SimpleKind::sphere && std::abs(out.dot(shape.axis)) > std::cos(Tuning::poleMargin))
            return std::nullopt;
    }
    return gp_Ax3(place(cloud.centre + shape.origin * cloud.size), direction(shape.axis), direction(-middle));
}

Handle(Geom_ElementarySurface) cone(const SimpleShape& shape, gp_Ax3 axes, const Cloud& cloud) {
    double near = Tuning::maxRadius;
    for (const Vector3d& point : cloud.samples.points)
        near = std::min(near, shape.axis.dot(point - shape.origin));
    if (near < 1e-3) return nullptr; // too near to the apex
    axes.SetLocation(place(cloud.centre + (shape.origin + shape.axis * near) * cloud.size));
    return new Geom_ConicalSurface(axes, shape.second, near * std::tan(shape.second) * cloud.size);
}

Handle(Geom_ElementarySurface) surfaceOf(SimpleShape shape, const Cloud& cloud) {
    if (shape.kind == SimpleKind::plane)
        return new Geom_Plane(place(cloud.centre + shape.origin * cloud.size), direction(shape.axis));
    const auto axes = axesFor(shape, cloud);
    if (!axes || shape.radius > Tuning::maxRadius || shape.second > Tuning::maxRadius) return nullptr;
    switch (shape.kind) {
    case SimpleKind::cylinder:
        return new Geom_CylindricalSurface(*axes, shape.radius * cloud.size);
    case SimpleKind::cone:
        return cone(shape, *axes, cloud);
    case SimpleKind::sphere:
        return new Geom_SphericalSurface(*axes, shape.radius * cloud.size);
    default:
        return new Geom_ToroidalSurface(*axes, shape.radius * cloud.size, shape.second * cloud.size);
    }
}

/// Around the tube of a torus, from its outermost circle, the middle of the points.
double tubeAngle(const SimpleShape& torus, const OrientedPoints& samples) {
    double away = 0;
    double height = 0;
    for (const Vector3d& point : samples.points) {
        const Vector3d normal = torus.normal(point);
        away += normal.dot(torus.radial(point).normalized());
        height += normal.dot(torus.axis);
    }
    return std::atan2(height, away);
}

} // namespace

std::optional<SimpleSurface> planeOf(const Patch& clampedPatch, double tolerance) {
    OrientedPoints net;
    for (const Point& point : clampedPatch.controlPoints)
        net.points.push_back(vector(point));
    auto plane = fitShape(SimpleKind::plane, net);
    for (const Vector3d& point : net.points)
        if (!(std::abs(plane->distance(point)) <= tolerance)) return std::nullopt;
    const Cloud cloud = cloudOf(clampedPatch, 5);
    if (cloud.samples.points.empty()) return std::nullopt;
    Vector3d normal(0, 0, 0);
    for (const Vector3d& at : cloud.samples.normals)
        normal += at;
    if (plane->axis.dot(normal) < 0) plane->axis = -plane->axis;
    for (const Vector3d& at : cloud.samples.normals) // a patch that is folded in its plane stays what it is
        if (at.dot(plane->axis) < 0) return std::nullopt;
    return SimpleSurface{surfaceOf(*plane, Cloud{}), false, 0};
}

std::optional<SimpleSurface> simpleSurfaceOf(const Patch& clampedPatch, double tolerance) {
    const Cloud coarse = cloudOf(clampedPatch, 12);
    if (coarse.samples.points.size() < 10) return std::nullopt;
    for (const SimpleKind kind :
         {SimpleKind::plane, SimpleKind::cylinder, SimpleKind::cone, SimpleKind::sphere, SimpleKind::torus}) {
        const auto shape = fitShape(kind, coarse.samples);
        if (!shape || agreement(*shape, coarse.samples, tolerance / coarse.size) == 0) continue;
        const Cloud fine = cloudOf(clampedPatch, 1000);
        const int side = agreement(*shape, fine.samples, tolerance / fine.size);
        if (side == 0) continue;
        SimpleShape facing = *shape;
        if (kind == SimpleKind::plane) facing.axis *= side;
        const Handle(Geom_ElementarySurface) surface = surfaceOf(facing, fine);
        if (!surface.IsNull())
            return SimpleSurface{surface, kind != SimpleKind::plane && side < 0,
                                 kind == SimpleKind::torus ? tubeAngle(facing, fine.samples) : 0};
    }
    return std::nullopt;
}

} // namespace qm

#include "export/simple_surface.h"

#include "bspline/splines/eigen_point.h"
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
    /// Of radial directions: if they all but cancel, the patch goes around, and no side is free for the seam.
    static constexpr double minMean = 1e-3;
    /// Of an axis, the part across the direction to the patch: with less, any other direction serves better.
    static constexpr double minAcross = 0.1;
    /// Between patch and a cone's apex, in sizes of the patch.
    static constexpr double apexMargin = 1e-3;
    /// Samples of every knot interval: one more than the degree.
    static constexpr int samplesPerInterval = 4;
};

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
        const auto normal = unitNormal(at.du, at.dv);
        if (!normal) continue;
        cloud.samples.points.emplace_back((vector(at.position) - cloud.centre) / cloud.size);
        cloud.samples.normals.push_back(vector(*normal));
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
    return gp_Ax3(place(cloud.centre + shape.origin * cloud.size), direction(shape.axis), direction(-middle));
}

Handle(Geom_ElementarySurface) cone(const SimpleShape& shape, gp_Ax3 axes, const Cloud& cloud) {
    double near = Tuning::maxRadius;
    for (const Vector3d& point : cloud.samples.points)
        near = std::min(near, shape.axis.dot(point - shape.origin));
    if (near < Tuning::apexMargin) return nullptr;
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

/// The same points from another origin and in another unit.
Cloud inFrame(Cloud cloud, const Vector3d& centre, double size) {
    for (Vector3d& point : cloud.samples.points)
        point = (cloud.centre + point * cloud.size - centre) / size;
    cloud.centre = centre;
    cloud.size = size;
    return cloud;
}

/// Patches that lie on one surface, or a patch alone.
struct Group {
    Cloud cloud; ///< of all
    std::optional<SimpleShape> shape;
    double tolerance = 0;
};

std::optional<SimpleShape> fittingShape(SimpleKind kind, const Group& group) {
    auto shape = fitShape(kind, group.cloud.samples);
    if (shape && agreement(*shape, group.cloud.samples, group.tolerance / group.cloud.size) == 0) return {};
    return shape;
}

/// The first kind that fits.
std::optional<SimpleShape> recognised(const Group& group) {
    if (group.cloud.samples.points.size() < 10) return std::nullopt;
    for (const SimpleKind kind :
         {SimpleKind::plane, SimpleKind::cylinder, SimpleKind::cone, SimpleKind::sphere, SimpleKind::torus})
        if (auto shape = fittingShape(kind, group)) return shape;
    return std::nullopt;
}

/// Both as one group, if there is one surface for both.
std::optional<Group> united(const Group& one, const Group& other) {
    if (!one.shape || !other.shape || one.shape->kind != other.shape->kind) return std::nullopt;
    const Vector3d centre = (one.cloud.centre + other.cloud.centre) / 2;
    const double size =
        (one.cloud.centre - other.cloud.centre).norm() + (one.cloud.size + other.cloud.size) / 2;
    Group result{inFrame(one.cloud, centre, size), std::nullopt, std::min(one.tolerance, other.tolerance)};
    const Cloud more = inFrame(other.cloud, centre, size);
    auto& samples = result.cloud.samples;
    samples.points.insert(samples.points.end(), more.samples.points.begin(), more.samples.points.end());
    samples.normals.insert(samples.normals.end(), more.samples.normals.begin(), more.samples.normals.end());
    result.shape = fittingShape(one.shape->kind, result);
    if (!result.shape) return std::nullopt;
    return result;
}

/// The group's surface with its seam on the other side of a patch.
std::optional<SimpleSurface> surfaceFor(const Group& group, const Cloud& patch, double tolerance) {
    const Cloud cloud = inFrame(patch, group.cloud.centre, group.cloud.size);
    const int side = agreement(*group.shape, cloud.samples, tolerance / cloud.size);
    if (side == 0) return std::nullopt;
    SimpleShape facing = *group.shape;
    const bool isPlane = facing.kind == SimpleKind::plane;
    if (isPlane) facing.axis *= side;
    const Handle(Geom_ElementarySurface) surface = surfaceOf(facing, cloud);
    if (surface.IsNull()) return std::nullopt;
    return SimpleSurface{surface, !isPlane && side < 0,
                         facing.kind == SimpleKind::torus ? tubeAngle(facing, cloud.samples) : 0};
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

std::vector<std::optional<SimpleSurface>>
simpleSurfacesOf(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                 const std::vector<std::array<std::size_t, 2>>& smoothNeighbours) {
    std::vector<Group> groups(clampedPatches.size());
    std::vector<std::size_t> groupOf(clampedPatches.size());
    for (std::size_t k = 0; k < clampedPatches.size(); ++k) {
        groups[k] = {cloudOf(clampedPatches[k], 12), std::nullopt, tolerances[k]};
        if (tolerances[k] > 0) groups[k].shape = recognised(groups[k]);
        groupOf[k] = k;
    }
    const std::vector<Group> alone = groups;
    for (const auto& [one, other] : smoothNeighbours) {
        const std::size_t into = groupOf[one];
        const std::size_t from = groupOf[other];
        if (into == from) continue;
        auto both = united(groups[into], groups[from]);
        if (!both) continue;
        groups[into] = std::move(*both);
        std::ranges::replace(groupOf, from, into);
    }
    std::vector<std::optional<SimpleSurface>> result(clampedPatches.size());
    for (std::size_t k = 0; k < clampedPatches.size(); ++k) {
        if (!alone[k].shape) continue;
        const Cloud fine = cloudOf(clampedPatches[k], 1000);
        result[k] = surfaceFor(groups[groupOf[k]], fine, tolerances[k]);
        if (!result[k]) result[k] = surfaceFor(alone[k], fine, tolerances[k]);
    }
    return result;
}

} // namespace qm

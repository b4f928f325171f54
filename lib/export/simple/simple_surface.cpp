#include "export/simple/simple_surface.h"

#include "base/at.h"
#include "bspline/splines/eigen_point.h"
#include "export/simple/elementary_surface.h"
#include "export/simple/patch_cloud.h"
#include "export/simple/shape_regions.h"
#include "export/simple/simple_shape_fit.h"

#include <Eigen/Geometry>

#include <Geom_Plane.hxx>
#include <cmath>
#include <utility>

namespace qm {
namespace {

using Eigen::Vector3d;

/// Samples of a patch in either direction, at most.
struct MaxSamples {
    static constexpr std::size_t ofNormals = 5;  ///< to see which way a plane looks
    static constexpr std::size_t ofFit = 12;     ///< to find a shape, or one of several patches
    static constexpr std::size_t ofPatch = 1000; ///< to verify it, once
};

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

/// The region's surface with its seam on the other side of a patch.
std::optional<SimpleSurface> surfaceFor(const ShapeRegion& region, const PatchCloud& patch,
                                        double tolerance) {
    const PatchCloud cloud = inFrame(patch, region.cloud.centre, region.cloud.size);
    if (!isAlong(region.shape, region.side, cloud.samples, tolerance / cloud.size, region.limits))
        return std::nullopt;
    SimpleShape facing = region.shape;
    const bool isPlane = facing.kind == SimpleKind::plane;
    if (isPlane) facing.axis *= region.side;
    const Handle(Geom_ElementarySurface) surface = elementarySurface(facing, cloud);
    if (surface.IsNull()) return std::nullopt;
    return SimpleSurface{surface, !isPlane && region.side < 0,
                         facing.kind == SimpleKind::torus ? tubeAngle(facing, cloud.samples) : 0};
}

std::optional<SimpleShape> shapeOfPlane(const std::optional<SimpleSurface>& surface) {
    if (!surface) return std::nullopt;
    const auto& axis = surface->surface->Axis();
    const auto vectorOf = [](const gp_XYZ& at) { return Vector3d(at.X(), at.Y(), at.Z()); };
    return SimpleShape{SimpleKind::plane, vectorOf(axis.Location().XYZ()), vectorOf(axis.Direction().XYZ())};
}

ShapePatches shapePatches(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                          const std::vector<std::optional<SimpleSurface>>& planes,
                          const std::vector<SmoothBorder>& borders) {
    ShapePatches result{{}, tolerances, {}, std::vector<std::vector<std::size_t>>(clampedPatches.size())};
    for (std::size_t k = 0; k < clampedPatches.size(); ++k) {
        result.clouds.push_back(cloudOf(clampedPatches[k], MaxSamples::ofFit));
        result.planes.push_back(shapeOfPlane(planes[k]));
        if (planes[k]) result.tolerances[k] = 0;
    }
    for (const auto& [patches, points, normals] : borders)
        for (const std::size_t k : {0U, 1U})
            result.neighbours[patches.at(k)].push_back(patches.at(1 - k));
    return result;
}

} // namespace

std::optional<SimpleSurface> planeOf(const Patch& clampedPatch, double tolerance) {
    OrientedPoints net;
    for (const Point& point : clampedPatch.controlPoints)
        net.points.push_back(vector(point));
    auto plane = fitShape(SimpleKind::plane, net);
    for (const Vector3d& point : net.points)
        if (!(std::abs(plane->distance(point)) <= tolerance)) return std::nullopt;
    const PatchCloud cloud = cloudOf(clampedPatch, MaxSamples::ofNormals);
    if (cloud.samples.points.empty()) return std::nullopt;
    Vector3d normal(0, 0, 0);
    for (const Vector3d& at : cloud.samples.normals)
        normal += at;
    if (plane->axis.dot(normal) < 0) plane->axis = -plane->axis;
    for (const Vector3d& at : cloud.samples.normals) // a patch that is folded in its plane stays what it is
        if (at.dot(plane->axis) < 0) return std::nullopt;
    return SimpleSurface{elementarySurface(*plane, PatchCloud{}), false, 0};
}

std::vector<std::optional<SimpleSurface>> simpleSurfacesOf(const std::vector<Patch>& clampedPatches,
                                                           const std::vector<double>& tolerances,
                                                           std::vector<std::optional<SimpleSurface>> planes,
                                                           const std::vector<SmoothBorder>& borders) {
    const ShapePatches patches = shapePatches(clampedPatches, tolerances, planes, borders);
    std::vector<std::optional<PlacedShape>> placed(clampedPatches.size());
    std::vector<std::optional<SimpleSurface>> result = std::move(planes);
    for (std::size_t k = 0; k < result.size(); ++k)
        if (patches.planes[k]) placed[k] = {*patches.planes[k]};
    for (const ShapeRegion& region : shapeRegions(patches))
        for (const std::size_t patch : region.patches) {
            if (patches.planes[patch]) continue;
            const PatchCloud fine = cloudOf(clampedPatches[patch], MaxSamples::ofPatch);
            result[patch] = surfaceFor(region, fine, tolerances[patch]);
            if (result[patch])
                placed[patch] = {fromFrame(region.shape, region.cloud.centre, region.cloud.size), region.side,
                                 region.area, true};
        }
    keepSmooth(borders, placed);
    for (std::size_t k = 0; k < result.size(); ++k)
        if (!placed[k]) result[k].reset();
    return result;
}

} // namespace qm

#include "export/simple/simple_surface.h"

#include "base/disjoint_sets.h"
#include "bspline/splines/eigen_point.h"
#include "export/simple/elementary_surface.h"
#include "export/simple/patch_cloud.h"
#include "export/simple/simple_shape_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace qm {
namespace {

using Eigen::Vector3d;

/// Largest angles between the normals of a patch and of what takes its place, in radians.
struct NormalLimits {
    /// Root mean square: with more, another shape is meant.
    static constexpr double rms = 3 * (std::numbers::pi / 180);
    /// Fits wave within their tolerance, most of all at rims and along what was cut into facets.
    static constexpr double largest = 10 * (std::numbers::pi / 180);
    /// Patches that are plane wave little, and hardly any of those that differ by more has an outline in a
    /// plane.
    static constexpr double largestOfPlane = 3 * (std::numbers::pi / 180);
};

/// Samples of a patch in either direction, at most.
struct MaxSamples {
    static constexpr std::size_t ofNormals = 5;  ///< to see which way a plane looks
    static constexpr std::size_t ofFit = 12;     ///< to find a shape, or one of several patches
    static constexpr std::size_t ofPatch = 1000; ///< to verify it, once
};

/// Largest distance from a curved surface, as a share of that from a plane. What bends less is within the
/// tolerance of many surfaces, none of which is meant.
constexpr double maxShareOfBulge = 0.25;

/// What `fitShape` asks for.
constexpr std::size_t minPoints = 10;

/// \return 1, or -1 if the shape's normals point the other way than the points'
int sideOf(const SimpleShape& shape, const OrientedPoints& samples) {
    return shape.normal(samples.points.front()).dot(samples.normals.front()) < 0 ? -1 : 1;
}

/// Whether the shape lies along the points, on this side of all of them.
bool isAlong(const SimpleShape& shape, int side, const OrientedPoints& samples, double tolerance) {
    const double largest =
        shape.kind == SimpleKind::plane ? NormalLimits::largestOfPlane : NormalLimits::largest;
    double squares = 0;
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
        if (std::abs(shape.distance(samples.points[k])) > tolerance) return false;
        const Vector3d normal = side * shape.normal(samples.points[k]);
        const double angle =
            std::atan2(normal.cross(samples.normals[k]).norm(), normal.dot(samples.normals[k]));
        if (!(angle <= largest)) return false;
        squares += angle * angle;
    }
    return squares <= NormalLimits::rms * NormalLimits::rms * static_cast<double>(samples.points.size());
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

/// Patches that lie on one surface, or a patch alone.
struct Group {
    PatchCloud cloud; ///< of all
    std::optional<SimpleShape> shape;
    double tolerance = 0;
    bool isFitted = true; ///< the shape is the best for all points, not only within the tolerance
};

std::optional<SimpleShape> fittingShape(SimpleKind kind, const Group& group) {
    const OrientedPoints& samples = group.cloud.samples;
    auto shape = fitShape(kind, samples);
    const double tolerance = group.tolerance / group.cloud.size;
    if (shape && !isAlong(*shape, sideOf(*shape, samples), samples, tolerance)) return std::nullopt;
    return shape;
}

/// The first kind that fits.
std::optional<SimpleShape> recognised(const Group& group) {
    if (group.cloud.samples.points.size() < minPoints) return std::nullopt;
    for (const SimpleKind kind :
         {SimpleKind::plane, SimpleKind::cylinder, SimpleKind::cone, SimpleKind::sphere, SimpleKind::torus})
        if (auto shape = fittingShape(kind, group)) return shape;
    return std::nullopt;
}

/// Gives a group the best surface of its kind.
/// \return false if that is not within the tolerance, and nothing has changed
bool refit(Group& group) {
    Group fitted{centred(group.cloud), std::nullopt, group.tolerance};
    fitted.shape = fittingShape(group.shape->kind, fitted);
    if (!fitted.shape) return false;
    group = std::move(fitted);
    return true;
}

/// Moves the patches of the smaller group into the larger one, if there is one surface for both: for now the
/// larger group's, if that will do. Then only the smaller group's points are looked at, or uniting many
/// patches one by one would look at all of them every time.
/// \return false if there is no such surface, and nothing has changed
bool unite(Group& larger, const Group& smaller) {
    if (!larger.shape || !smaller.shape || larger.shape->kind != smaller.shape->kind) return false;
    const PatchCloud more = inFrame(smaller.cloud, larger.cloud.centre, larger.cloud.size);
    const auto append = [&](Group& group) {
        OrientedPoints& samples = group.cloud.samples;
        samples.points.insert(samples.points.end(), more.samples.points.begin(), more.samples.points.end());
        samples.normals.insert(samples.normals.end(), more.samples.normals.begin(),
                               more.samples.normals.end());
    };
    const double tolerance = smaller.tolerance / larger.cloud.size;
    const int side = sideOf(*larger.shape, larger.cloud.samples);
    if (isAlong(*larger.shape, side, more.samples, tolerance) &&
        (smaller.tolerance >= larger.tolerance ||
         isAlong(*larger.shape, side, larger.cloud.samples, tolerance))) {
        append(larger);
        larger.tolerance = std::min(larger.tolerance, smaller.tolerance);
        larger.isFitted = false;
        return true;
    }
    Group both = larger;
    append(both);
    both.tolerance = std::min(larger.tolerance, smaller.tolerance);
    if (!refit(both)) return false;
    larger = std::move(both);
    return true;
}

/// Unites groups of one patch each with those of smooth neighbours.
/// \return by patch: the number of its group
std::vector<std::size_t> uniteNeighbours(std::vector<Group>& groups,
                                         const std::vector<std::array<std::size_t, 2>>& smoothNeighbours) {
    DisjointSets sets(groups.size());
    std::set<std::pair<std::size_t, std::size_t>> isInVain; // more patches do not make it easier
    for (const auto& [one, other] : smoothNeighbours) {
        std::size_t into = sets.find(one);
        std::size_t from = sets.find(other);
        if (into == from || isInVain.contains(std::minmax(into, from))) continue;
        const auto points = [&](std::size_t k) { return groups[k].cloud.samples.points.size(); };
        if (points(into) < points(from)) std::swap(into, from);
        if (unite(groups[into], groups[from])) {
            sets.join(into, from);
            if (sets.find(into) != into) groups[from] = std::move(groups[into]);
        } else {
            isInVain.insert(std::minmax(into, from));
        }
    }
    std::vector<std::size_t> groupOf;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        groupOf.push_back(sets.find(k));
        if (groupOf[k] == k && !groups[k].isFitted) refit(groups[k]);
    }
    return groupOf;
}

double farthest(const SimpleShape& shape, const OrientedPoints& samples) {
    double distance = 0;
    for (const Vector3d& point : samples.points)
        distance = std::max(distance, std::abs(shape.distance(point)));
    return distance;
}

/// Whether a group's shape is a plane, or says clearly more than one.
bool isMeant(const Group& group) {
    if (!group.shape || group.shape->kind == SimpleKind::plane) return group.shape.has_value();
    const OrientedPoints& samples = group.cloud.samples;
    const auto plane = fitShape(SimpleKind::plane, samples);
    return plane && farthest(*group.shape, samples) <= maxShareOfBulge * farthest(*plane, samples);
}

/// The group's surface with its seam on the other side of a patch.
std::optional<SimpleSurface> surfaceFor(const Group& group, const PatchCloud& patch, double tolerance) {
    const PatchCloud cloud = inFrame(patch, group.cloud.centre, group.cloud.size);
    const int side = sideOf(*group.shape, cloud.samples);
    if (!isAlong(*group.shape, side, cloud.samples, tolerance / cloud.size)) return std::nullopt;
    SimpleShape facing = *group.shape;
    const bool isPlane = facing.kind == SimpleKind::plane;
    if (isPlane) facing.axis *= side;
    const Handle(Geom_ElementarySurface) surface = elementarySurface(facing, cloud);
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

std::vector<std::optional<SimpleSurface>>
simpleSurfacesOf(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                 const std::vector<std::array<std::size_t, 2>>& smoothNeighbours) {
    std::vector<Group> groups(clampedPatches.size());
    for (std::size_t k = 0; k < clampedPatches.size(); ++k) {
        groups[k] = {cloudOf(clampedPatches[k], MaxSamples::ofFit), std::nullopt, tolerances[k]};
        if (tolerances[k] > 0) groups[k].shape = recognised(groups[k]);
    }
    const std::vector<Group> alone = groups;
    const std::vector<std::size_t> groupOf = uniteNeighbours(groups, smoothNeighbours);
    std::vector<bool> isGroupMeant(groups.size());
    for (std::size_t k = 0; k < groups.size(); ++k)
        isGroupMeant[k] = groupOf[k] == k && isMeant(groups[k]);
    std::vector<std::optional<SimpleSurface>> result(clampedPatches.size());
    for (std::size_t k = 0; k < clampedPatches.size(); ++k) {
        if (!alone[k].shape) continue;
        const PatchCloud fine = cloudOf(clampedPatches[k], MaxSamples::ofPatch);
        if (isGroupMeant[groupOf[k]]) result[k] = surfaceFor(groups[groupOf[k]], fine, tolerances[k]);
        if (!result[k] && isMeant(alone[k])) result[k] = surfaceFor(alone[k], fine, tolerances[k]);
    }
    return result;
}

} // namespace qm

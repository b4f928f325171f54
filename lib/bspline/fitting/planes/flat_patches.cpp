#include "bspline/fitting/planes/flat_patches.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "bspline/reference/planes/principal_axes.h"
#include "bspline/splines/eigen_point.h"
#include "layout/sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <unordered_map>
#include <utility>

namespace qm {
namespace {

/// The plane through the reference points of some patches, if there is one.
/// \param patches  the patches whose points it must contain
/// \param share    largest distance of the points from it, relative to their smaller extent: small patches
/// are not plane just because they bend little in absolute terms
std::optional<Plane> planeThrough(const std::vector<ReferenceGrid>& reference,
                                  std::span<const std::size_t> patches, double tolerance, double share) {
    std::vector<Eigen::Vector3d> points;
    for (const std::size_t patch : patches)
        std::ranges::transform(reference[patch].points, std::back_inserter(points), vector);
    const PrincipalAxes spread = principalAxes(points);
    const Eigen::Vector3d normal = spread.axes.col(0);
    const double allowed = std::min(tolerance, share * spread.extents[1]);
    const bool isPlane = std::ranges::all_of(points, [&](const Eigen::Vector3d& at) {
        return std::abs(normal.dot(at - spread.middle)) < allowed;
    });
    return isPlane ? std::optional(Plane{point(normal), normal.dot(spread.middle)}) : std::nullopt;
}

/// Finds planes for those patches that are plane together with their smooth neighbours.
void findPlanes(const std::vector<ReferenceGrid>& reference, const SmoothNetwork& network, double tolerance,
                const std::vector<bool>& isPlane, std::vector<std::optional<Plane>>& planes) {
    DisjointSets groups(reference.size());
    for (const SmoothRun& run : network.runs) {
        const auto& sides = network.stretches[run.stretch].sides;
        if (isPlane[sides[0].patch] && isPlane[sides[1].patch]) groups.join(sides[0].patch, sides[1].patch);
    }
    for (const auto& patches : groups.members()) {
        if (!isPlane[patches.front()]) continue;
        const auto plane = planeThrough(reference, patches, tolerance, maxThickness);
        for (const std::size_t patch : patches)
            planes[patch] = plane;
    }
}

/// By patch: the plane of its reference, if it has one. Plane patches that meet smoothly share one plane.
std::vector<std::optional<Plane>> planesOf(const std::vector<ReferenceGrid>& reference,
                                           const SmoothNetwork& network, double tolerance) {
    std::vector<std::optional<Plane>> planes(reference.size());
    std::vector<bool> isPlane(reference.size());
    const auto look = [&](double share) {
        for (std::size_t k = 0; k < reference.size(); ++k)
            isPlane[k] =
                !planes[k] && planeThrough(reference, std::span(&k, 1), tolerance, share).has_value();
        findPlanes(reference, network, tolerance, isPlane, planes);
    };
    look(1);            // finds narrow patches between others of the same plane
    look(maxThickness); // where such a chain bends, finds the patches that are plane without doubt
    return planes;
}

/// A side of a plane patch on the outline.
struct OutlineSide {
    std::size_t patch = 0;
    int side = 0;
    std::vector<Eigen::Vector3d> points; ///< of the reference

    [[nodiscard]] Eigen::Vector3d direction() const { return (points.back() - points.front()).normalized(); }
};

struct StraightLine {
    Eigen::Vector3d middle;
    Eigen::Vector3d direction; ///< unit
};

std::vector<Eigen::Vector3d> pointsOnSide(const ReferenceGrid& grid, int side) {
    const std::array<std::size_t, 2> count{grid.columns(), grid.rows()};
    std::vector<Eigen::Vector3d> points;
    for (std::size_t k = 0; k < count[directionAlong(side)]; ++k)
        points.push_back(vector(grid.points[pointOnSide(count, side, k)]));
    return points;
}

/// By patch and side: whether no patch lies beyond any part of it.
std::vector<std::array<bool, 4>> outlineSides(const SmoothNetwork& network, std::size_t patches) {
    std::vector<std::array<bool, 4>> result(patches, {true, true, true, true});
    for (const Stretch& stretch : network.stretches)
        for (const StretchSide& place : stretch.sides)
            result[place.patch][at(place.side)] = false;
    return result;
}

/// The line through all points, if there is one; as with planes, short ones must be the straighter.
std::optional<StraightLine> lineThrough(const std::vector<Eigen::Vector3d>& points, double tolerance) {
    constexpr double straight = 1e-4; // share of its extent that a line may be thick
    const PrincipalAxes spread = principalAxes(points);
    const Eigen::Vector3d direction = spread.axes.col(2);
    const double allowed = std::min(tolerance, straight * spread.extents[2]);
    const bool isStraight = std::ranges::all_of(points, [&](const Eigen::Vector3d& at) {
        return direction.cross(at - spread.middle).norm() < allowed;
    });
    return isStraight ? std::optional(StraightLine{spread.middle, direction}) : std::nullopt;
}

/// Divides straight sides into those that continue one another: where lines turn by less than this, points on
/// both would have no certain place.
/// \return their places in the list
std::vector<std::vector<std::size_t>> continued(const Layout& layout, const std::vector<OutlineSide>& sides) {
    const double turn = std::cos(0.2);
    std::unordered_map<VertexId, std::vector<std::size_t>> sidesAt;
    DisjointSets sets(sides.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const auto& path = layout.segments[sides[k].patch].sides[at(sides[k].side)];
        for (const VertexId end : {path.front(), path.back()}) {
            for (const std::size_t other : sidesAt[end])
                if (std::abs(sides[k].direction().dot(sides[other].direction())) > turn) sets.join(k, other);
            sidesAt[end].push_back(k);
        }
    }
    return sets.members();
}

} // namespace

std::vector<std::optional<FlatPatch>> flatPatches(const Layout& layout,
                                                  const std::vector<ReferenceGrid>& reference,
                                                  const SmoothNetwork& network, double tolerance) {
    const std::vector<std::optional<Plane>> planes = planesOf(reference, network, tolerance);
    const auto isOutline = outlineSides(network, planes.size());
    std::vector<std::optional<FlatPatch>> flat(planes.size());
    std::vector<OutlineSide> sides;
    for (std::size_t patch = 0; patch < planes.size(); ++patch) {
        if (!planes[patch]) continue;
        flat[patch] = FlatPatch{*planes[patch], {}};
        for (int side = 0; side < 4; ++side) {
            if (!isOutline[patch][at(side)]) continue;
            OutlineSide found{patch, side, pointsOnSide(reference[patch], side)};
            if (lineThrough(found.points, tolerance)) sides.push_back(std::move(found));
        }
    }
    for (const auto& group : continued(layout, sides)) {
        std::vector<Eigen::Vector3d> points;
        for (const std::size_t k : group)
            std::ranges::copy(sides[k].points, std::back_inserter(points));
        const std::optional<StraightLine> line = lineThrough(points, tolerance);
        if (!line) continue;
        for (const std::size_t k : group) {
            FlatPatch& patch = *flat[sides[k].patch];
            const Eigen::Vector3d normal = line->direction.cross(vector(patch.plane.normal)).normalized();
            patch.outlines[at(sides[k].side)] = Plane{point(normal), normal.dot(line->middle)};
        }
    }
    return flat;
}

} // namespace qm

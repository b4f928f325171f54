#include "bspline/reference/planes/plane_patches.h"

#include "base/disjoint_sets.h"
#include "bspline/reference/planes/principal_axes.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>

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

} // namespace

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

} // namespace qm

#include "bspline/reference/scan/scan_projection.h"

#include "base/order_statistics.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

using Nearest = TriangleSurface::Nearest;

/// Smallest cosine of the angle between the normals of surface and scan: 60 degrees.
constexpr double minCosine = 0.5;

/// The distance from the scan that this share of the points have at most. The scan's holes do not count.
double commonDistance(const std::vector<std::optional<Nearest>>& nearest, double share) {
    std::vector<double> distances;
    for (const std::optional<Nearest>& place : nearest)
        if (place && !place->onBoundary) distances.push_back(place->distance);
    return quantile(distances, share);
}

/// Of the angle between a normal and a direction; 0 where there is no normal.
double cosineOf(const std::optional<Point>& normal, const Eigen::Vector3d& direction) {
    return normal ? vector(*normal).dot(direction) : 0;
}

/// 1 if most of the scan's normals agree with the surface's, -1 if most are opposite, 0 if neither. Those
/// that are near count alone: far ones may be another side of the part.
double orientation(const LatticeNormals& lattice, const std::vector<std::optional<Nearest>>& nearest) {
    constexpr std::size_t clearly = 3; // times as many as the others
    constexpr double nearShare = 0.25;
    const double near = commonDistance(nearest, nearShare);
    std::size_t along = 0;
    std::size_t against = 0;
    for (std::size_t k = 0; k < nearest.size(); ++k)
        if (nearest[k] && !nearest[k]->onBoundary && nearest[k]->distance <= near)
            ++(cosineOf(nearest[k]->normal, *lattice.normals[k]) > 0 ? along : against);
    if (along >= clearly * against) return 1;
    return against >= clearly * along ? -1 : 0;
}

/// The scan is looked for up to `farFactor` times as far as this share of the points are from it. The others
/// may be where it shows nothing.
constexpr double farShare = 0.9;
constexpr double farFactor = 4;

/// How one point finds its place on the scan.
class Projector {
public:
    Projector(const TriangleSurface& scan, double maxDistance, double orientation)
        : scan_(scan), maxDistance_(maxDistance), orientation_(orientation) {}

    [[nodiscard]] Displacement project(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                                       const std::optional<Nearest>& nearest) const {
        if (!nearest || nearest->distance > maxDistance_) return std::nullopt;
        const bool fits = agrees(*nearest, normal);
        // A line that meets the same piece of the scan does so at most this far away.
        const double reach = fits ? std::min(nearest->distance / minCosine, maxDistance_) : maxDistance_;
        std::optional<Nearest> hit = onLine(place, normal, reach);
        if (!hit && fits) hit = nearest;
        if (!hit || hit->onBoundary) return std::nullopt;
        return vector(hit->position) - place;
    }

private:
    [[nodiscard]] bool agrees(const Nearest& place, const Eigen::Vector3d& normal) const {
        const double cosine = cosineOf(place.normal, normal);
        return (orientation_ == 0 ? std::abs(cosine) : orientation_ * cosine) >= minCosine;
    }

    [[nodiscard]] std::optional<Nearest> onLine(const Eigen::Vector3d& place, const Eigen::Vector3d& normal,
                                                double reach) const {
        const auto towards = [&](double sign) {
            return scan_.alongLine(point(place), point(sign * normal), reach, minCosine);
        };
        if (orientation_ != 0) return towards(orientation_);
        const std::optional<Nearest> along = towards(1), against = towards(-1);
        if (!along || !against) return along ? along : against;
        return along->distance <= against->distance ? along : against;
    }

    const TriangleSurface& scan_;
    double maxDistance_;
    double orientation_;
};

} // namespace

ScanProjection projectOntoScan(const LatticeNormals& lattice, const TriangleSurface& scan,
                               const ScanReach& reach, unsigned jobs) {
    const std::size_t count = lattice.points.size();
    std::vector<std::optional<Nearest>> nearest(count);
    parallelForMany(count, jobs, [&](std::size_t k) {
        if (lattice.normals[k]) nearest[k] = scan.nearest(point(lattice.points[k]), reach.max);
    });
    ScanProjection result;
    result.maxDistance = std::clamp(farFactor * commonDistance(nearest, farShare), reach.min, reach.max);
    const Projector projector(scan, result.maxDistance, orientation(lattice, nearest));
    result.displacements.resize(count);
    parallelForMany(count, jobs, [&](std::size_t k) {
        if (const auto& normal = lattice.normals[k])
            result.displacements[k] = projector.project(lattice.points[k], *normal, nearest[k]);
    });
    return result;
}

} // namespace qm

#include "export/simple/patch_cloud.h"

#include "bspline/splines/eigen_point.h"
#include "bspline/splines/evaluate.h"
#include "export/geometry/curve_piece.h"
#include "mesh/bounding_box.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>
#include <vector>

namespace qm {
namespace {

using Eigen::Vector3d;

/// One more than the degree.
constexpr int samplesPerInterval = 4;

/// At both ends of every knot interval and between; at most `max` parameters, evenly, the ends among them.
std::vector<double> parameters(const std::vector<double>& knots, std::size_t max) {
    std::vector<double> values = steppedKnots(knots, samplesPerInterval);
    if (values.size() <= max) return values;
    std::vector<double> result;
    for (std::size_t k = 0; k < max; ++k)
        result.push_back(values[k * (values.size() - 1) / (max - 1)]);
    return result;
}

} // namespace

PatchCloud cloudOf(const Patch& patch, std::size_t max) {
    PatchCloud cloud;
    const BoundingBox box = boundingBoxOf(patch.controlPoints);
    cloud.centre = vector(box.centre());
    cloud.size = vector(box.size()).norm();
    if (!(cloud.size > 0)) return cloud;
    for (const SurfacePoint& at :
         evaluateLattice(patch, parameters(patch.knots[0], max), parameters(patch.knots[1], max))) {
        const Vector3d across = vector(at.du).cross(vector(at.dv));
        const auto normal = unitNormal(at.du, at.dv);
        if (!normal) continue;
        cloud.area += across.norm();
        cloud.samples.points.emplace_back((vector(at.position) - cloud.centre) / cloud.size);
        cloud.samples.normals.push_back(vector(*normal));
    }
    const auto [u, v] = domain(patch);
    cloud.area *= (u[1] - u[0]) * (v[1] - v[0]);
    cloud.area /= static_cast<double>(std::max<std::size_t>(1, cloud.samples.points.size()));
    return cloud;
}

PatchCloud inFrame(PatchCloud cloud, const Vector3d& centre, double size) {
    for (Vector3d& point : cloud.samples.points)
        point = (cloud.centre + point * cloud.size - centre) / size;
    cloud.centre = centre;
    cloud.size = size;
    return cloud;
}

void append(PatchCloud& cloud, const PatchCloud& more) {
    const PatchCloud moved = inFrame(more, cloud.centre, cloud.size);
    OrientedPoints& all = cloud.samples;
    all.points.insert(all.points.end(), moved.samples.points.begin(), moved.samples.points.end());
    all.normals.insert(all.normals.end(), moved.samples.normals.begin(), moved.samples.normals.end());
    cloud.area += more.area;
}

PatchCloud centred(PatchCloud cloud) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : cloud.samples.points)
        box.extend(point);
    if (!(box.diagonal().norm() > 0)) return cloud;
    const Vector3d centre = cloud.centre + box.center() * cloud.size;
    const double size = box.diagonal().norm() * cloud.size;
    return inFrame(std::move(cloud), centre, size);
}

} // namespace qm

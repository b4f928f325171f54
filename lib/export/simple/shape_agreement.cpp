#include "export/simple/shape_agreement.h"

#include "export/simple/simple_shape_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

/// Largest distance from a curved surface, as a share of that from a plane.
constexpr double maxShareOfBulge = 0.25;

/// What `fitShape` asks for.
constexpr std::size_t minPoints = 10;

} // namespace

int sideOf(const SimpleShape& shape, const OrientedPoints& samples) {
    return shape.normal(samples.points.front()).dot(samples.normals.front()) < 0 ? -1 : 1;
}

bool isAlong(const SimpleShape& shape, int side, const OrientedPoints& samples, double tolerance,
             const WaveLimits& limits) {
    const double largest =
        (shape.kind == SimpleKind::plane ? limits.largestOfPlane : limits.largest) * degree;
    double squares = 0;
    for (std::size_t k = 0; k < samples.points.size(); ++k) {
        if (std::abs(shape.distance(samples.points[k])) > tolerance) return false;
        const Vector3d normal = side * shape.normal(samples.points[k]);
        const double angle =
            std::atan2(normal.cross(samples.normals[k]).norm(), normal.dot(samples.normals[k]));
        if (!(angle <= largest)) return false;
        squares += angle * angle;
    }
    const double rms = limits.rms * degree;
    return squares <= rms * rms * static_cast<double>(samples.points.size());
}

double farthest(const SimpleShape& shape, const OrientedPoints& samples) {
    double distance = 0;
    for (const Vector3d& point : samples.points)
        distance = std::max(distance, std::abs(shape.distance(point)));
    return distance;
}

std::optional<SimpleShape> fittingShape(SimpleKind kind, const OrientedPoints& samples, double tolerance,
                                        const WaveLimits& limits) {
    if (samples.points.size() < minPoints) return std::nullopt;
    auto shape = fitShape(kind, samples);
    if (shape && !isAlong(*shape, sideOf(*shape, samples), samples, tolerance, limits)) return std::nullopt;
    return shape;
}

bool isMeant(const SimpleShape& shape, const OrientedPoints& samples) {
    if (shape.kind == SimpleKind::plane) return true;
    if (shape.radius > maxRadius || shape.tubeRadius > maxRadius) return false;
    const auto plane = fitShape(SimpleKind::plane, samples);
    return plane && farthest(shape, samples) <= maxShareOfBulge * farthest(*plane, samples);
}

} // namespace qm

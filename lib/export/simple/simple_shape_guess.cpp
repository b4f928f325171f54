#include "export/simple/simple_shape_fit.h"
#include "export/simple/small_matrices.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace qm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d mean(const std::vector<Vector3d>& vectors) {
    return std::accumulate(vectors.begin(), vectors.end(), Vector3d(0, 0, 0)) /
           static_cast<double>(vectors.size());
}

/// The direction in which vectors differ the least from `from`.
Vector3d directionOfMinSpread(const std::vector<Vector3d>& vectors, const Vector3d& from) {
    Matrix3d sum = Matrix3d::Zero();
    for (const Vector3d& vector : vectors)
        sum += (vector - from) * (vector - from).transpose();
    return minEigenvector(sum);
}

SimpleShape firstPlane(const OrientedPoints& cloud) {
    SimpleShape plane;
    plane.origin = mean(cloud.points);
    plane.axis = directionOfMinSpread(cloud.points, plane.origin);
    return plane;
}

/// Centre and radius of what is a sphere, or a circle, in a projection: its normals are a radius long and end
/// in the centre.
template <class Projection>
Eigen::Vector4d centreAndRadius(const OrientedPoints& cloud, const Projection& projected) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        Eigen::Matrix<double, 3, 4> row;
        row << Matrix3d::Identity(), projected(cloud.normals[k]);
        sum += row.transpose() * row;
        right += row.transpose() * projected(cloud.points[k]);
    }
    return minNormSolution(sum, right);
}

/// All normals are orthogonal to the axis; seen along it, the cylinder is a circle.
SimpleShape firstCylinder(const OrientedPoints& cloud) {
    const Vector3d axis = directionOfMinSpread(cloud.normals, {0, 0, 0});
    const Eigen::Vector4d circle =
        centreAndRadius(cloud, [&](const Vector3d& v) -> Vector3d { return v - axis * axis.dot(v); });
    return {SimpleKind::cylinder, circle.head<3>(), axis, std::abs(circle[3])};
}

SimpleShape firstSphere(const OrientedPoints& cloud) {
    const Eigen::Vector4d sphere = centreAndRadius(cloud, [](const Vector3d& v) { return v; });
    return {SimpleKind::sphere, sphere.head<3>(), {0, 0, 1}, std::abs(sphere[3])};
}

/// All normals make one angle with the axis, and all tangent planes pass through the apex.
SimpleShape firstCone(const OrientedPoints& cloud) {
    SimpleShape cone{SimpleKind::cone, {}, directionOfMinSpread(cloud.normals, mean(cloud.normals))};
    Matrix3d sum = Matrix3d::Zero();
    Vector3d right(0, 0, 0);
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        const Vector3d& normal = cloud.normals[k];
        sum += normal * normal.transpose();
        right += normal * normal.dot(cloud.points[k]);
    }
    cone.origin = minNormSolution(sum, right);
    if (cone.axis.dot(mean(cloud.points) - cone.origin) < 0) cone.axis = -cone.axis;
    cone.halfAngle = std::asin(std::clamp(std::abs(cone.axis.dot(mean(cloud.normals))), 0.0, 1.0));
    return cone;
}

/// The normals of a surface of revolution all meet its axis: a linear complex
/// (docs/METHOD.md#pottmann-2001). Around it, points are a radius away from one circle.
SimpleShape firstTorus(const OrientedPoints& cloud) {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        Vector6 line;
        line << cloud.points[k].cross(cloud.normals[k]), cloud.normals[k];
        sum += line * line.transpose();
    }
    const Vector6 axis = minEigenvector(sum);
    SimpleShape torus{SimpleKind::torus};
    const double length = axis.head<3>().norm();
    constexpr double shortest = 1e-6; // a shorter direction means that the complex is no axis
    if (length < shortest) return torus;
    torus.axis = axis.head<3>() / length;
    const Vector3d foot = torus.axis.cross(axis.tail<3>() / length);
    // In the half plane (distance from the axis, height): a circle by its algebraic equation.
    Matrix3d normal = Matrix3d::Zero();
    Vector3d right(0, 0, 0);
    for (const Vector3d& point : cloud.points) {
        const double height = torus.axis.dot(point - foot);
        const double away = (point - foot - torus.axis * height).norm();
        const Vector3d row(away, height, 1);
        normal += row * row.transpose();
        right += row * (away * away + height * height);
    }
    const Vector3d circle = normal.completeOrthogonalDecomposition().solve(right);
    torus.radius = circle[0] / 2;
    torus.origin = foot + torus.axis * (circle[1] / 2);
    torus.tubeRadius =
        std::sqrt(std::max(circle[2] + torus.radius * torus.radius + circle[1] * circle[1] / 4, 0.0));
    return torus;
}

} // namespace

SimpleShape guessShape(SimpleKind kind, const OrientedPoints& cloud) {
    switch (kind) {
    case SimpleKind::plane:
        return firstPlane(cloud);
    case SimpleKind::cylinder:
        return firstCylinder(cloud);
    case SimpleKind::cone:
        return firstCone(cloud);
    case SimpleKind::sphere:
        return firstSphere(cloud);
    default:
        return firstTorus(cloud);
    }
}

} // namespace qm

#include "export/simple_shape_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
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
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(sum).eigenvectors().col(0);
}

SimpleShape firstPlane(const OrientedPoints& cloud) {
    SimpleShape plane;
    plane.origin = mean(cloud.points);
    plane.axis = directionOfMinSpread(cloud.points, plane.origin);
    return plane;
}

/// All normals are orthogonal to the axis; seen along it, points are a radius away from the centre along
/// them.
SimpleShape firstCylinder(const OrientedPoints& cloud) {
    SimpleShape cylinder{SimpleKind::cylinder, {}, directionOfMinSpread(cloud.normals, {0, 0, 0}), 0, 0};
    const auto flat = [&](const Vector3d& v) -> Vector3d { return v - cylinder.axis * cylinder.axis.dot(v); };
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        Eigen::Matrix<double, 3, 4> row;
        row << Matrix3d::Identity(), flat(cloud.normals[k]);
        sum += row.transpose() * row;
        right += row.transpose() * flat(cloud.points[k]);
    }
    const Eigen::Vector4d solution = sum.completeOrthogonalDecomposition().solve(right);
    cylinder.origin = solution.head<3>();
    cylinder.radius = std::abs(solution[3]);
    return cylinder;
}

/// Normals are a radius long and end in the centre.
SimpleShape firstSphere(const OrientedPoints& cloud) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        Eigen::Matrix<double, 3, 4> row;
        row << Matrix3d::Identity(), cloud.normals[k];
        sum += row.transpose() * row;
        right += row.transpose() * cloud.points[k];
    }
    const Eigen::Vector4d solution = sum.completeOrthogonalDecomposition().solve(right);
    return {SimpleKind::sphere, solution.head<3>(), {0, 0, 1}, std::abs(solution[3]), 0};
}

/// All normals make one angle with the axis, and all tangent planes pass through the apex.
SimpleShape firstCone(const OrientedPoints& cloud) {
    SimpleShape cone{SimpleKind::cone, {}, directionOfMinSpread(cloud.normals, mean(cloud.normals)), 0, 0};
    Matrix3d sum = Matrix3d::Zero();
    Vector3d right(0, 0, 0);
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        const Vector3d& normal = cloud.normals[k];
        sum += normal * normal.transpose();
        right += normal * normal.dot(cloud.points[k]);
    }
    cone.origin = sum.completeOrthogonalDecomposition().solve(right);
    if (cone.axis.dot(mean(cloud.points) - cone.origin) < 0) cone.axis = -cone.axis;
    cone.second = std::asin(std::clamp(std::abs(cone.axis.dot(mean(cloud.normals))), 0.0, 1.0));
    return cone;
}

/// The normals of a surface of revolution all meet its axis: a linear complex (Pottmann and Wallner). Around
/// it, points are a radius away from one circle.
SimpleShape firstTorus(const OrientedPoints& cloud) {
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t k = 0; k < cloud.points.size(); ++k) {
        Vector6 line;
        line << cloud.points[k].cross(cloud.normals[k]), cloud.normals[k];
        sum += line * line.transpose();
    }
    const Vector6 axis =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>>(sum).eigenvectors().col(0);
    SimpleShape torus{SimpleKind::torus, {}, {0, 0, 1}, 0, 0};
    const double length = axis.head<3>().norm();
    if (length < 1e-6) return torus;
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
    torus.second =
        std::sqrt(std::max(circle[2] + torus.radius * torus.radius + circle[1] * circle[1] / 4, 0.0));
    return torus;
}

using Change = Eigen::Matrix<double, 7, 1>;

SimpleShape changed(SimpleShape shape, const Change& by) {
    const Vector3d across = shape.axis.unitOrthogonal();
    shape.origin += by.head<3>();
    shape.axis = (shape.axis + by[3] * across + by[4] * shape.axis.cross(across)).normalized();
    shape.radius += by[5];
    shape.second += by[6];
    return shape;
}

double squares(const SimpleShape& shape, const OrientedPoints& cloud) {
    double sum = 0;
    for (const Vector3d& point : cloud.points)
        sum += shape.distance(point) * shape.distance(point);
    return sum;
}

/// Gauss and Newton's method with numerical derivatives; what does not count for the kind does not move, as
/// of all solutions the smallest is taken.
SimpleShape refined(SimpleShape shape, const OrientedPoints& cloud) {
    constexpr int rounds = 12;
    constexpr double step = 1e-6;
    double before = squares(shape, cloud);
    for (int round = 0; round < rounds; ++round) {
        Eigen::Matrix<double, 7, 7> sum = Eigen::Matrix<double, 7, 7>::Zero();
        Change right = Change::Zero();
        std::array<SimpleShape, 7> forwards;
        std::array<SimpleShape, 7> backwards;
        for (int k = 0; k < 7; ++k) {
            forwards.at(static_cast<std::size_t>(k)) = changed(shape, step * Change::Unit(k));
            backwards.at(static_cast<std::size_t>(k)) = changed(shape, -step * Change::Unit(k));
        }
        for (const Vector3d& point : cloud.points) {
            Change slope;
            for (int k = 0; k < 7; ++k)
                slope[k] = (forwards.at(static_cast<std::size_t>(k)).distance(point) -
                            backwards.at(static_cast<std::size_t>(k)).distance(point)) /
                           (2 * step);
            sum += slope * slope.transpose();
            right -= slope * shape.distance(point);
        }
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 7, 7>> solver;
        solver.setThreshold(1e-10);
        solver.compute(sum);
        const SimpleShape next = changed(shape, solver.solve(right));
        const double after = squares(next, cloud);
        if (!(after < before)) break;
        shape = next;
        before = after;
    }
    return shape;
}

/// Whether numbers are such as the kind can have.
bool isSound(const SimpleShape& shape) {
    constexpr double smallestAngle = 0.5 * std::numbers::pi / 180;
    if (!shape.origin.allFinite() || !shape.axis.allFinite()) return false;
    switch (shape.kind) {
    case SimpleKind::plane:
        return true;
    case SimpleKind::cone:
        return shape.second > smallestAngle && shape.second < std::numbers::pi / 2 - smallestAngle;
    case SimpleKind::torus:
        return shape.second > 0 && shape.radius > shape.second;
    default:
        return shape.radius > 0;
    }
}

} // namespace

double SimpleShape::distance(const Vector3d& point) const {
    const Vector3d from = point - origin;
    const double height = axis.dot(from);
    const double away = (from - axis * height).norm();
    switch (kind) {
    case SimpleKind::plane:
        return height;
    case SimpleKind::cylinder:
        return away - radius;
    case SimpleKind::cone:
        return away * std::cos(second) - height * std::sin(second);
    case SimpleKind::sphere:
        return from.norm() - radius;
    default:
        return std::hypot(away - radius, height) - second;
    }
}

Vector3d SimpleShape::radial(const Vector3d& point) const {
    const Vector3d from = point - origin;
    return kind == SimpleKind::sphere ? from : from - axis * axis.dot(from);
}

Vector3d SimpleShape::normal(const Vector3d& point) const {
    const Vector3d out = radial(point).normalized();
    switch (kind) {
    case SimpleKind::plane:
        return axis;
    case SimpleKind::cone:
        return out * std::cos(second) - axis * std::sin(second);
    case SimpleKind::torus:
        return (point - origin - out * radius).normalized();
    default:
        return out;
    }
}

std::optional<SimpleShape> fitShape(SimpleKind kind, const OrientedPoints& cloud) {
    SimpleShape first;
    switch (kind) {
    case SimpleKind::plane:
        return firstPlane(cloud);
    case SimpleKind::cylinder:
        first = firstCylinder(cloud);
        break;
    case SimpleKind::cone:
        first = firstCone(cloud);
        break;
    case SimpleKind::sphere:
        first = firstSphere(cloud);
        break;
    case SimpleKind::torus:
        first = firstTorus(cloud);
        break;
    }
    if (!isSound(first)) return std::nullopt;
    const SimpleShape shape = refined(first, cloud);
    return isSound(shape) ? std::optional(shape) : std::nullopt;
}

} // namespace qm

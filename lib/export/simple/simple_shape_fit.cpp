#include "export/simple/simple_shape_fit.h"

#include "base/at.h"
#include "export/simple/small_matrices.h"

#include <Eigen/Geometry>

#include <array>
#include <numbers>

namespace qm {
namespace {

using Eigen::Vector3d;

using Change = Eigen::Matrix<double, 7, 1>;

SimpleShape changed(SimpleShape shape, const Change& by) {
    const Vector3d across = shape.axis.unitOrthogonal();
    shape.origin += by.head<3>();
    shape.axis = (shape.axis + by[3] * across + by[4] * shape.axis.cross(across)).normalized();
    shape.radius += by[5];
    (shape.kind == SimpleKind::cone ? shape.halfAngle : shape.tubeRadius) += by[6];
    return shape;
}

double squares(const SimpleShape& shape, const OrientedPoints& cloud) {
    double sum = 0;
    for (const Vector3d& point : cloud.points)
        sum += shape.distance(point) * shape.distance(point);
    return sum;
}

/// The Gauss-Newton method with numerical derivatives. Numbers that mean nothing for the kind stay as they
/// are, because of all solutions the smallest is taken.
SimpleShape refined(SimpleShape shape, const OrientedPoints& cloud) {
    constexpr int rounds = 12;        // it ends before, where no round gets nearer
    constexpr double step = 1e-6;     // of points of about unit size: the cube root of what doubles resolve
    constexpr double unmoved = 1e-10; // of the largest pivot: what does not count for the kind
    double before = squares(shape, cloud);
    for (int round = 0; round < rounds; ++round) {
        Eigen::Matrix<double, 7, 7> sum = Eigen::Matrix<double, 7, 7>::Zero();
        Change right = Change::Zero();
        std::array<SimpleShape, 7> forwards;
        std::array<SimpleShape, 7> backwards;
        for (int k = 0; k < 7; ++k) {
            forwards[at(k)] = changed(shape, step * Change::Unit(k));
            backwards[at(k)] = changed(shape, -step * Change::Unit(k));
        }
        for (const Vector3d& point : cloud.points) {
            Change slope;
            for (int k = 0; k < 7; ++k)
                slope[k] = (forwards[at(k)].distance(point) - backwards[at(k)].distance(point)) / (2 * step);
            sum += slope * slope.transpose();
            right -= slope * shape.distance(point);
        }
        const SimpleShape next = changed(shape, minNormSolution(sum, right, unmoved));
        const double after = squares(next, cloud);
        if (!(after < before)) break;
        shape = next;
        before = after;
    }
    return shape;
}

/// Whether numbers are such as the kind can have.
bool isSound(const SimpleShape& shape) {
    // A cone's half angle below this is a cylinder's, one so near to a right angle a plane's.
    constexpr double smallestAngle = 0.5 * std::numbers::pi / 180;
    if (!shape.origin.allFinite() || !shape.axis.allFinite()) return false;
    switch (shape.kind) {
    case SimpleKind::plane:
        return true;
    case SimpleKind::cone:
        return shape.halfAngle > smallestAngle && shape.halfAngle < std::numbers::pi / 2 - smallestAngle;
    case SimpleKind::torus:
        return shape.tubeRadius > 0 && shape.radius > shape.tubeRadius;
    default:
        return shape.radius > 0;
    }
}

} // namespace

std::optional<SimpleShape> fitShape(SimpleKind kind, const OrientedPoints& cloud) {
    const SimpleShape first = guessShape(kind, cloud);
    if (kind == SimpleKind::plane) return first;
    if (!isSound(first)) return std::nullopt;
    const SimpleShape shape = refined(first, cloud);
    return isSound(shape) ? std::optional(shape) : std::nullopt;
}

} // namespace qm

#include "bspline/splines/evaluate.h"

#include "base/at.h"
#include "bspline/splines/eigen_point.h"

namespace qm {
namespace {

using Row = std::vector<Eigen::Vector3d>;

/// The control points of the curve v = const for which successive rows have these weights.
void collapse(const Patch& patch, std::size_t first, const std::array<double, maxDegree + 1>& weights,
              Row& row) {
    const std::size_t columns = at(patch.count[0]);
    row.assign(columns, Eigen::Vector3d::Zero());
    for (std::size_t j = 0; j <= at(patch.degree[1]); ++j)
        for (std::size_t i = 0; i < columns; ++i)
            row[i] += weights[j] * vector(patch.controlPoints[(first + j) * columns + i]);
}

/// The point of such a curve, or its derivative, where successive points have these weights.
Point combine(const Row& row, std::size_t first, const std::array<double, maxDegree + 1>& weights,
              int degree) {
    Eigen::Vector3d sum = weights[0] * row[first];
    for (std::size_t i = 1; i <= at(degree); ++i)
        sum += weights[i] * row[first + i];
    return point(sum);
}

} // namespace

ParameterBox domain(const Patch& patch) {
    return {domain(patch.knots[0], patch.degree[0]), domain(patch.knots[1], patch.degree[1])};
}

SurfacePoint evaluate(const Patch& patch, const BasisValues& u, const BasisValues& v) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d du = Eigen::Vector3d::Zero();
    Eigen::Vector3d dv = Eigen::Vector3d::Zero();
    const std::size_t columns = at(patch.count[0]);
    const std::size_t lastU = at(patch.degree[0]);
    const std::size_t lastV = at(patch.degree[1]);
    for (std::size_t j = 0; j <= lastV; ++j) {
        if (v.value[j] == 0 && v.derivative[j] == 0) continue; // on a border, half of them
        const Point* row = patch.controlPoints.data() + (v.first + j) * columns + u.first;
        Eigen::Vector3d onRow = Eigen::Vector3d::Zero();
        Eigen::Vector3d slope = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i <= lastU; ++i) {
            onRow += u.value[i] * vector(row[i]);
            slope += u.derivative[i] * vector(row[i]);
        }
        position += v.value[j] * onRow;
        du += v.value[j] * slope;
        dv += v.derivative[j] * onRow;
    }
    return {point(position), point(du), point(dv)};
}

Point pointAt(const std::vector<Patch>& patches, const LayoutPlace& place) {
    return evaluate(patches[place.patch], place.at[0], place.at[1]).position;
}

SurfacePoint evaluate(const Patch& patch, double u, double v) {
    return evaluate(patch, basisValues(patch.knots[0], patch.degree[0], u),
                    basisValues(patch.knots[1], patch.degree[1], v));
}

std::vector<SurfacePoint> evaluateLattice(const Patch& patch, std::span<const double> us,
                                          std::span<const double> vs) {
    const auto tableU = basisTable(patch.knots[0], patch.degree[0], us);
    const auto tableV = basisTable(patch.knots[1], patch.degree[1], vs);
    const int degree = patch.degree[0];
    std::vector<SurfacePoint> points;
    points.reserve(us.size() * vs.size());
    Row row;
    Row slopes;
    for (const BasisValues& v : tableV) {
        collapse(patch, v.first, v.value, row);
        collapse(patch, v.first, v.derivative, slopes);
        for (const BasisValues& u : tableU)
            points.push_back({combine(row, u.first, u.value, degree),
                              combine(row, u.first, u.derivative, degree),
                              combine(slopes, u.first, u.value, degree)});
    }
    return points;
}

std::vector<Point> positionLattice(const Patch& patch, const std::vector<BasisValues>& us,
                                   const std::vector<BasisValues>& vs) {
    std::vector<Point> positions;
    positions.reserve(us.size() * vs.size());
    Row row;
    for (const BasisValues& v : vs) {
        collapse(patch, v.first, v.value, row);
        for (const BasisValues& u : us)
            positions.push_back(combine(row, u.first, u.value, patch.degree[0]));
    }
    return positions;
}

Point unit(const Point& vector) {
    const double length = vector.norm();
    return length > 0 ? vector / length : Point(0, 0, 0);
}

Point SurfacePoint::normal() const {
    return unitNormal(du, dv).value_or(Point(0, 0, 0));
}

std::optional<Point> unitNormal(const Point& du, const Point& dv) {
    const Point normal = du % dv;
    const double length = normal.norm();
    constexpr double rounding = 1e-12; // of a sine: parallel derivatives leave nothing else
    if (!(length > rounding * du.norm() * dv.norm())) return std::nullopt;
    return normal / length;
}

} // namespace qm

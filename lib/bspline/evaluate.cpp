#include "bspline/evaluate.h"

#include <cmath>
#include <numbers>

namespace qm {
namespace {

/// The control points of the curve v = const for which successive rows have these weights.
void collapse(const Patch& patch, std::size_t first, const std::array<double, maxDegree + 1>& weights,
              std::vector<Point>& row) {
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    row.assign(columns, Point(0, 0, 0));
    for (std::size_t j = 0; j <= static_cast<std::size_t>(patch.degree[1]); ++j)
        for (std::size_t i = 0; i < columns; ++i)
            row[i] += weights[j] * patch.controlPoints[(first + j) * columns + i];
}

} // namespace

std::array<std::array<double, 2>, 2> domain(const Patch& patch) {
    return {domain(patch.knots[0], patch.degree[0]), domain(patch.knots[1], patch.degree[1])};
}

SurfacePoint evaluate(const Patch& patch, const BasisValues& u, const BasisValues& v) {
    SurfacePoint result;
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    const auto lastU = static_cast<std::size_t>(patch.degree[0]);
    const auto lastV = static_cast<std::size_t>(patch.degree[1]);
    for (std::size_t j = 0; j <= lastV; ++j) {
        if (v.value[j] == 0 && v.derivative[j] == 0) continue; // on a border, half of them
        const Point* row = patch.controlPoints.data() + (v.first + j) * columns + u.first;
        Point onRow{0, 0, 0};
        Point slope{0, 0, 0};
        for (std::size_t i = 0; i <= lastU; ++i) {
            onRow += u.value[i] * row[i];
            slope += u.derivative[i] * row[i];
        }
        result.position += v.value[j] * onRow;
        result.du += v.value[j] * slope;
        result.dv += v.derivative[j] * onRow;
    }
    return result;
}

SurfacePoint evaluate(const Patch& patch, double u, double v) {
    return evaluate(patch, basisValues(patch.knots[0], patch.degree[0], u),
                    basisValues(patch.knots[1], patch.degree[1], v));
}

std::vector<SurfacePoint> evaluateLattice(const Patch& patch, std::span<const double> us,
                                          std::span<const double> vs) {
    const auto tableU = basisTable(patch.knots[0], patch.degree[0], us);
    const auto tableV = basisTable(patch.knots[1], patch.degree[1], vs);
    const auto lastU = static_cast<std::size_t>(patch.degree[0]);
    std::vector<SurfacePoint> points;
    points.reserve(us.size() * vs.size());
    std::vector<Point> row;
    std::vector<Point> slopes;
    for (const BasisValues& v : tableV) {
        collapse(patch, v.first, v.value, row);
        collapse(patch, v.first, v.derivative, slopes);
        for (const BasisValues& u : tableU) {
            SurfacePoint& point = points.emplace_back();
            for (std::size_t i = 0; i <= lastU; ++i) {
                point.position += u.value[i] * row[u.first + i];
                point.du += u.derivative[i] * row[u.first + i];
                point.dv += u.value[i] * slopes[u.first + i];
            }
        }
    }
    return points;
}

std::vector<Point> positionLattice(const Patch& patch, const std::vector<BasisValues>& us,
                                   const std::vector<BasisValues>& vs) {
    const auto lastU = static_cast<std::size_t>(patch.degree[0]);
    std::vector<Point> positions;
    positions.reserve(us.size() * vs.size());
    std::vector<Point> row;
    for (const BasisValues& v : vs) {
        collapse(patch, v.first, v.value, row);
        for (const BasisValues& u : us) {
            Point& position = positions.emplace_back(0, 0, 0);
            for (std::size_t i = 0; i <= lastU; ++i)
                position += u.value[i] * row[u.first + i];
        }
    }
    return positions;
}

Point unitNormal(const Point& du, const Point& dv) {
    const Point normal = du % dv;
    const double length = normal.norm();
    // Parallel derivatives leave nothing but rounding.
    if (!(length > 1e-12 * du.norm() * dv.norm())) return {0, 0, 0};
    return normal / length;
}

double angleInDegrees(const Point& a, const Point& b) {
    return std::atan2((a % b).norm(), (a | b) + 0.0) * 180 / std::numbers::pi; // -0 would be half a turn
}

} // namespace qm

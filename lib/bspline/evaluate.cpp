#include "bspline/evaluate.h"

#include <cmath>
#include <numbers>

namespace qm {

std::array<std::array<double, 2>, 2> domain(const Patch& patch) {
    return {domain(patch.knots[0], patch.degree[0]), domain(patch.knots[1], patch.degree[1])};
}

SurfacePoint evaluate(const Patch& patch, const BasisValues& u, const BasisValues& v) {
    SurfacePoint result;
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    const auto lastU = static_cast<std::size_t>(patch.degree[0]);
    const auto lastV = static_cast<std::size_t>(patch.degree[1]);
    for (std::size_t j = 0; j <= lastV; ++j) {
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
    std::vector<SurfacePoint> points;
    points.reserve(us.size() * vs.size());
    for (const BasisValues& v : tableV)
        for (const BasisValues& u : tableU)
            points.push_back(evaluate(patch, u, v));
    return points;
}

Point unitNormal(const Point& du, const Point& dv) {
    const Point normal = du % dv;
    const double length = normal.norm();
    // Parallel derivatives leave nothing but rounding.
    if (!(length > 1e-12 * du.norm() * dv.norm())) return {0, 0, 0};
    return normal / length;
}

double angleInDegrees(const Point& a, const Point& b) {
    return std::atan2((a % b).norm(), a | b) * 180 / std::numbers::pi;
}

} // namespace qm

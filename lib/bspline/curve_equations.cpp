#include "bspline/curve_equations.h"

#include "bspline/eigen_point.h"
#include "bspline/profile_factor.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace qm {
namespace {

/// Makes the matrix quasi-definite, so that it can be factorised even where conditions depend on one another;
/// repetition takes its effect away.
constexpr double regularisation = 1e-6;

} // namespace

CurveEquations::CurveEquations(std::size_t points)
    : points_(points), blocks_(4 * points, Eigen::Matrix3d::Zero()),
      right_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * points))) {}

void CurveEquations::add(std::size_t first, const CurveWeights& weights, const Eigen::Matrix3d& metric,
                         const Point& target) {
    const Eigen::Vector3d right = metric * vector(target);
    for (std::size_t a = 0; a < 4; ++a) {
        right_.segment<3>(static_cast<Eigen::Index>(3 * (first + a))) += weights[a] * right;
        for (std::size_t b = a; b < 4; ++b)
            blocks_[4 * (first + a) + b - a] += weights[a] * weights[b] * metric;
    }
}

void CurveEquations::pull(std::size_t point, const Point& target) {
    constexpr double weight = 1e-6;
    right_.segment<3>(static_cast<Eigen::Index>(3 * point)) += weight * vector(target);
    blocks_[4 * point].diagonal().array() += weight;
}

void CurveEquations::require(std::size_t first, const CurveWeights& weights, const Point& direction,
                             double value) {
    Condition condition{first, {}, value};
    for (std::size_t a = 0; a < 4; ++a)
        condition.coefficients.segment<3>(static_cast<Eigen::Index>(3 * a)) = weights[a] * vector(direction);
    conditions_.push_back(condition);
}

std::vector<Point> CurveEquations::solve() const {
    // Every condition follows the last control point that it concerns: that keeps rows short.
    std::vector<std::size_t> order(conditions_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return conditions_[k].first; });
    std::vector<std::size_t> rowOfPoint(points_);
    std::vector<std::size_t> rowOfCondition(conditions_.size());
    std::vector<std::size_t> first;
    auto next = order.begin();
    for (std::size_t point = 0; point < points_; ++point) {
        rowOfPoint[point] = first.size();
        first.insert(first.end(), 3, rowOfPoint[point < 3 ? 0 : point - 3]);
        for (; next != order.end() && conditions_[*next].first + 3 == point; ++next) {
            rowOfCondition[*next] = first.size();
            first.push_back(rowOfPoint[point - 3]);
        }
    }

    const std::size_t size = first.size();
    ProfileFactor matrix(std::move(first));
    for (std::size_t point = 0; point < points_; ++point)
        for (std::size_t off = 0; off < 4 && point + off < points_; ++off)
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < (off == 0 ? r + 1 : 3); ++c)
                    matrix.at(rowOfPoint[point + off] + r, rowOfPoint[point] + c) =
                        blocks_[4 * point + off](static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
        const Condition& condition = conditions_[k];
        for (std::size_t m = 0; m < 12; ++m)
            matrix.at(rowOfCondition[k], rowOfPoint[condition.first + m / 3] + m % 3) =
                condition.coefficients[static_cast<Eigen::Index>(m)];
        matrix.at(rowOfCondition[k], rowOfCondition[k]) = -regularisation;
    }
    matrix.factorise();

    Eigen::VectorXd right(static_cast<Eigen::Index>(size));
    for (std::size_t point = 0; point < points_; ++point)
        right.segment<3>(static_cast<Eigen::Index>(rowOfPoint[point])) =
            right_.segment<3>(static_cast<Eigen::Index>(3 * point));
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(right.size());
    for (int round = 0; round < 4; ++round) {
        for (std::size_t k = 0; k < conditions_.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(rowOfCondition[k]);
            right[row] = conditions_[k].value - regularisation * solution[row];
        }
        solution = matrix.solve(right);
    }
    std::vector<Point> points;
    for (const std::size_t row : rowOfPoint) {
        const auto at = static_cast<Eigen::Index>(row);
        points.emplace_back(solution[at], solution[at + 1], solution[at + 2]);
    }
    return points;
}

} // namespace qm

#include "bspline/curve_equations.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace qm {
namespace {

/// Makes the matrix quasi-definite, so that it can be factorised even where conditions depend on one another;
/// repetition takes its effect away.
constexpr double regularisation = 1e-6;

using SparseMatrix = Eigen::SparseMatrix<double>;

Eigen::Vector3d vector(const Point& point) {
    return {point[0], point[1], point[2]};
}

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

/// Calls visit(row, column, value) for all entries of the lower triangle.
template <class Visitor> void CurveEquations::visitLower(const Visitor& visit) const {
    for (std::size_t point = 0; point < points_; ++point)
        for (std::size_t off = 0; off < 4 && point + off < points_; ++off)
            for (Eigen::Index r = 0; r < 3; ++r)
                for (Eigen::Index c = 0; c < (off == 0 ? r + 1 : 3); ++c)
                    visit(static_cast<Eigen::Index>(3 * (point + off)) + r,
                          static_cast<Eigen::Index>(3 * point) + c, blocks_[4 * point + off](r, c));
    Eigen::Index row = right_.size();
    for (const Condition& condition : conditions_) {
        for (Eigen::Index k = 0; k < condition.coefficients.size(); ++k)
            if (condition.coefficients[k] != 0)
                visit(row, static_cast<Eigen::Index>(3 * condition.first) + k, condition.coefficients[k]);
        visit(row, row, -regularisation);
        ++row;
    }
}

template <class Factor> std::vector<Point> CurveEquations::solve(const Factor& factor) const {
    const Eigen::Index unknowns = right_.size();
    const auto conditions = static_cast<Eigen::Index>(conditions_.size());
    Eigen::VectorXd right(unknowns + conditions);
    right.head(unknowns) = right_;
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(conditions);
    Eigen::VectorXd solution;
    for (int round = 0; round < 4; ++round) {
        for (Eigen::Index k = 0; k < conditions; ++k)
            right[unknowns + k] =
                conditions_[static_cast<std::size_t>(k)].value - regularisation * multipliers[k];
        solution = factor.solve(right);
        multipliers = solution.tail(conditions);
    }
    std::vector<Point> points;
    for (Eigen::Index k = 0; k < unknowns; k += 3)
        points.emplace_back(solution[k], solution[k + 1], solution[k + 2]);
    return points;
}

std::vector<Point> CurveEquations::solve() const {
    constexpr Eigen::Index few = 100;
    const Eigen::Index size = right_.size() + static_cast<Eigen::Index>(conditions_.size());
    if (size <= few) {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
        visitLower([&](Eigen::Index row, Eigen::Index column, double value) {
            matrix(row, column) = value;
            matrix(column, row) = value;
        });
        return solve(Eigen::PartialPivLU<Eigen::MatrixXd>(matrix));
    }
    std::vector<Eigen::Triplet<double, int>> entries;
    visitLower([&](Eigen::Index row, Eigen::Index column, double value) {
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    });
    SparseMatrix matrix(static_cast<int>(size), static_cast<int>(size));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return solve(Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower>(matrix));
}

} // namespace qm

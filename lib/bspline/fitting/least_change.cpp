#include "bspline/fitting/least_change.h"

#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

std::vector<Eigen::Triplet<double>> identity(Eigen::Index size) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index k = 0; k < size; ++k)
        entries.emplace_back(static_cast<int>(k), static_cast<int>(k), 1);
    return entries;
}

Eigen::Index row(const PlaneDemand& demand) {
    return static_cast<Eigen::Index>(demand.unknown);
}

/// Moves the point of every demand along the normal of its plane.
/// \param pressure  by demand: how far
Eigen::MatrixX3d spread(const std::vector<PlaneDemand>& demands, const Eigen::VectorXd& pressure,
                        Eigen::Index unknowns) {
    Eigen::MatrixX3d push = Eigen::MatrixX3d::Zero(unknowns, 3);
    for (std::size_t k = 0; k < demands.size(); ++k)
        push.row(row(demands[k])) +=
            pressure[static_cast<Eigen::Index>(k)] * vector(demands[k].plane.normal).transpose();
    return push;
}

/// By demand: the coordinate of its point along the normal of its plane.
Eigen::VectorXd heights(const std::vector<PlaneDemand>& demands, const Eigen::MatrixX3d& points) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(demands.size()));
    for (std::size_t k = 0; k < demands.size(); ++k)
        result[static_cast<Eigen::Index>(k)] =
            points.row(row(demands[k])).dot(vector(demands[k].plane.normal));
    return result;
}

} // namespace

LeastChange::LeastChange(std::size_t unknowns, std::vector<LinearForm> equations)
    : unknowns_(static_cast<Eigen::Index>(unknowns)), equations_(std::move(equations)),
      allowed_(unknowns, identity(unknowns_), equations_, {}, 1) {}

Eigen::MatrixX3d LeastChange::run(const std::vector<PlaneDemand>& demands, Eigen::MatrixX3d points) const {
    constexpr int passes = 4; // the later ones remove the rounding errors of those before
    constexpr double enough = 1e-14;
    for (int k = 0; k < passes && missingHeights(demands, points).lpNorm<Eigen::Infinity>() >
                                      enough * largestDistance(points);
         ++k)
        points += change(demands, points);
    return points;
}

double LeastChange::violation(const Eigen::MatrixX3d& change) const {
    double largest = 0;
    for (const LinearForm& equation : equations_) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            sum += equation.weights[k] * change.row(static_cast<Eigen::Index>(equation.unknowns[k]));
        largest = std::max(largest, sum.norm());
    }
    return largest;
}

Eigen::MatrixX3d LeastChange::change(const std::vector<PlaneDemand>& demands,
                                     const Eigen::MatrixX3d& points) const {
    constexpr int maxIterations = 120;
    constexpr double enough = 1e-15; // relative to the size of the points
    constexpr double worthwhile =
        1e-7; // relative to what is missing: drafts give no more digits, and the next pass does
    const double size = largestDistance(points);
    Eigen::VectorXd residual = missingHeights(demands, points);
    Eigen::VectorXd pressure = Eigen::VectorXd::Zero(residual.size());
    Eigen::VectorXd direction = residual;
    double square = residual.squaredNorm();
    const double limit = std::max(enough * size, worthwhile * residual.lpNorm<Eigen::Infinity>());
    for (int k = 0; k < maxIterations && residual.lpNorm<Eigen::Infinity>() > limit; ++k) {
        const Eigen::VectorXd effect =
            heights(demands, allowed(spread(demands, direction, unknowns_), Accuracy::draft));
        const double curvature = direction.dot(effect);
        if (!(curvature > 0)) break;
        const double step = square / curvature;
        pressure += step * direction;
        residual -= step * effect;
        const double next = residual.squaredNorm();
        direction = residual + next / square * direction;
        square = next;
    }
    return allowed(spread(demands, pressure, unknowns_), Accuracy::rounding);
}

/// The change that is nearest to the given one among those that the equations allow.
Eigen::MatrixX3d LeastChange::allowed(const Eigen::MatrixX3d& change, Accuracy accuracy) const {
    Eigen::MatrixX3d solution;
    allowed_.improve(change, accuracy, solution);
    return solution.topRows(unknowns_);
}

Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands, const Eigen::MatrixX3d& points) {
    Eigen::VectorXd result = -heights(demands, points);
    for (std::size_t k = 0; k < demands.size(); ++k)
        result[static_cast<Eigen::Index>(k)] += demands[k].plane.offset;
    return result;
}

double largestDistance(const Eigen::MatrixX3d& points) {
    return points.rowwise().norm().maxCoeff();
}

} // namespace qm

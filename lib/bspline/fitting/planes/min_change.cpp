#include "bspline/fitting/planes/min_change.h"

#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

constexpr std::size_t coordinates = 3;

/// The same equation for one coordinate, if all three of every point are numbered one after the other.
LinearForm ofCoordinate(LinearForm equation, std::size_t coordinate) {
    for (std::size_t& unknown : equation.unknowns)
        unknown = coordinates * unknown + coordinate;
    return equation;
}

/// The height of a demand's point over its plane, in the same numbering.
LinearForm height(const PlaneDemand& demand) {
    constexpr double rounding = 1e-15;
    LinearForm form;
    for (std::size_t k = 0; k < coordinates; ++k)
        if (const double weight = demand.plane.normal[k]; std::abs(weight) > rounding) {
            form.unknowns.push_back(coordinates * demand.unknown + k);
            form.weights.push_back(weight);
        }
    return form;
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

MinChange::MinChange(std::size_t unknowns, std::vector<LinearForm> equations)
    : unknowns_(static_cast<Eigen::Index>(unknowns)), equations_(std::move(equations)),
      allowed_(unknowns, identity(unknowns_), equations_, {}, 1) {}

Eigen::MatrixX3d MinChange::run(const std::vector<PlaneDemand>& demands,
                                const Eigen::MatrixX3d& points) const {
    std::vector<LinearForm> forms;
    forms.reserve(coordinates * equations_.size() + demands.size());
    for (const LinearForm& equation : equations_)
        for (std::size_t k = 0; k < coordinates; ++k)
            forms.push_back(ofCoordinate(equation, k));
    std::ranges::transform(demands, std::back_inserter(forms), height);
    const Eigen::VectorXd missing = missingHeights(demands, points);
    Eigen::MatrixX3d constants = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(forms.size()), 3);
    constants.col(0).tail(missing.size()) = missing; // the other columns are not needed
    const Eigen::Index all = 3 * unknowns_;
    const ConstrainedSystem system(static_cast<std::size_t>(all), identity(all), forms, constants, 1);
    Eigen::MatrixX3d solution;
    system.improve(Eigen::MatrixX3d::Zero(all, 3), Accuracy::rounding, solution);
    return points + allowed(solution.col(0).head(all).reshaped(3, unknowns_).transpose());
}

double MinChange::violation(const Eigen::MatrixX3d& change) const {
    double largest = 0;
    for (const LinearForm& equation : equations_) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            sum += equation.weights[k] * change.row(static_cast<Eigen::Index>(equation.unknowns[k]));
        largest = std::max(largest, sum.norm());
    }
    return largest;
}

/// The change that is nearest to the given one among those that the equations allow.
Eigen::MatrixX3d MinChange::allowed(const Eigen::MatrixX3d& change) const {
    Eigen::MatrixX3d solution;
    allowed_.improve(change, Accuracy::rounding, solution);
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

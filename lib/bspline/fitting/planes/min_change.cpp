#include "bspline/fitting/planes/min_change.h"

#include "bspline/splines/eigen_point.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace qm {
namespace {

/// Weight of the difference of what neighbours are moved by, beside the movement itself: those within two or
/// three rows follow. Points alone would be pushed over the next row where rows are close together.
constexpr double coupling = 3;

/// The lower half of the form by which changes are measured, if the coordinates of every point are numbered
/// one after the other.
Eigen::SparseMatrix<double> movement(std::size_t points, const std::vector<NeighbouringPoints>& neighbours,
                                     std::size_t coordinates) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(coordinates * (points + 3 * neighbours.size()));
    const auto add = [&](std::size_t row, std::size_t column, double value) {
        for (std::size_t k = 0; k < coordinates; ++k)
            entries.emplace_back(static_cast<int>(coordinates * row + k),
                                 static_cast<int>(coordinates * column + k), value);
    };
    for (std::size_t point = 0; point < points; ++point)
        add(point, point, 1);
    for (const auto& [one, other] : neighbours) {
        add(one, one, coupling);
        add(other, other, coupling);
        add(std::max(one, other), std::min(one, other), -coupling);
    }
    Eigen::SparseMatrix<double> lower(eigenIndex(coordinates * points), eigenIndex(coordinates * points));
    lower.setFromTriplets(entries.begin(), entries.end());
    return lower;
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

} // namespace

MinChange::MinChange(std::size_t points, std::vector<LinearForm> equations,
                     std::vector<NeighbouringPoints> neighbours)
    : points_(points), equations_(std::move(equations)), neighbours_(std::move(neighbours)),
      allowed_({movement(points, neighbours_, 1)}, equations_, {}, 1) {}

Eigen::MatrixX3d MinChange::run(const std::vector<PlaneDemand>& demands,
                                const Eigen::MatrixX3d& points) const {
    std::vector<LinearForm> forms;
    forms.reserve(coordinates * equations_.size() + demands.size());
    for (const LinearForm& equation : equations_)
        for (std::size_t k = 0; k < coordinates; ++k)
            forms.push_back(ofCoordinate(equation, k));
    std::ranges::transform(demands, std::back_inserter(forms), height);
    const Eigen::VectorXd missing = missingHeights(demands, points);
    Eigen::MatrixX3d constants = Eigen::MatrixX3d::Zero(eigenIndex(forms.size()), 3);
    constants.col(0).tail(missing.size()) = missing; // the other columns are not needed
    const ConstrainedSystem system({movement(points_, neighbours_, coordinates)}, std::move(forms), constants,
                                   1);
    const Eigen::Index all = eigenIndex(coordinates * points_);
    Eigen::MatrixX3d solution;
    system.improve(Eigen::MatrixX3d::Zero(all, 3), Accuracy::rounding, solution);
    return points + allowed(solution.col(0).head(all).reshaped(3, eigenIndex(points_)).transpose());
}

double MinChange::violation(const Eigen::MatrixX3d& change) const {
    double largest = 0;
    for (const LinearForm& equation : equations_) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            sum += equation.weights[k] * change.row(eigenIndex(equation.unknowns[k]));
        largest = std::max(largest, sum.norm());
    }
    return largest;
}

/// The change that is nearest to the given one among those that the equations allow.
Eigen::MatrixX3d MinChange::allowed(const Eigen::MatrixX3d& change) const {
    const Eigen::SparseMatrix<double> form = movement(points_, neighbours_, 1);
    Eigen::MatrixX3d solution;
    allowed_.improve(form.selfadjointView<Eigen::Lower>() * change, Accuracy::rounding, solution);
    return solution.topRows(eigenIndex(points_));
}

Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands, const Eigen::MatrixX3d& points) {
    Eigen::VectorXd result(eigenIndex(demands.size()));
    for (Eigen::Index k = 0; const auto& [unknown, plane] : demands)
        result[k++] = plane.offset - points.row(eigenIndex(unknown)).dot(vector(plane.normal));
    return result;
}

} // namespace qm

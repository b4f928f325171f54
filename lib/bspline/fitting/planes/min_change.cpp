#include "bspline/fitting/planes/min_change.h"

#include "base/at.h"
#include "bspline/splines/eigen_point.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace qm {
namespace {

/// A diagonal matrix in which each value is repeated.
std::vector<Eigen::Triplet<double>> diagonal(const std::vector<double>& values, std::size_t times) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const double value : values)
        for (std::size_t k = 0; k < times; ++k) {
            const int place = static_cast<int>(entries.size());
            entries.emplace_back(place, place, value);
        }
    return entries;
}

Eigen::Index row(std::size_t point) {
    return static_cast<Eigen::Index>(point);
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

/// The same demands of sets of points, without those that are equal.
std::vector<PlaneDemand> distinct(std::vector<PlaneDemand> demands, const std::vector<std::size_t>& setOf) {
    for (PlaneDemand& demand : demands)
        demand.unknown = setOf[demand.unknown];
    const auto key = [](const PlaneDemand& demand) {
        const auto& [normal, offset] = demand.plane;
        return std::tuple(demand.unknown, normal[0], normal[1], normal[2], offset);
    };
    std::ranges::sort(demands, {}, key);
    const auto isEqual = [&](const PlaneDemand& a, const PlaneDemand& b) { return key(a) == key(b); };
    demands.erase(std::unique(demands.begin(), demands.end(), isEqual), demands.end());
    return demands;
}

} // namespace

MinChange::MinChange(std::size_t unknowns, std::vector<LinearForm> equations)
    : equations_(std::move(equations)), tied_(tiedPoints(unknowns, equations_)),
      allowed_(tied_.sizes.size(), diagonal(tied_.sizes, 1), tied_.equations, {}, 1) {}

Eigen::MatrixX3d MinChange::run(const std::vector<PlaneDemand>& demands,
                                const Eigen::MatrixX3d& points) const {
    const Eigen::Index sets = row(tied_.sizes.size());
    Eigen::MatrixX3d pointOf(sets, 3);
    for (std::size_t k = 0; k < tied_.setOf.size(); ++k)
        pointOf.row(row(tied_.setOf[k])) = points.row(row(k));
    const std::vector<PlaneDemand> ofSets = distinct(demands, tied_.setOf);

    std::vector<LinearForm> forms;
    forms.reserve(coordinates * tied_.equations.size() + ofSets.size());
    for (const LinearForm& equation : tied_.equations)
        for (std::size_t k = 0; k < coordinates; ++k)
            forms.push_back(ofCoordinate(equation, k));
    std::ranges::transform(ofSets, std::back_inserter(forms), height);
    const Eigen::VectorXd missing = missingHeights(ofSets, pointOf);
    Eigen::MatrixX3d constants = Eigen::MatrixX3d::Zero(row(forms.size()), 3);
    constants.col(0).tail(missing.size()) = missing; // the other columns are not needed
    const Eigen::Index all = 3 * sets;
    const ConstrainedSystem system(at(all), diagonal(tied_.sizes, coordinates), forms, constants, 1);
    Eigen::MatrixX3d solution;
    system.improve(Eigen::MatrixX3d::Zero(all, 3), Accuracy::rounding, solution);
    const Eigen::MatrixX3d change = allowed(solution.col(0).head(all).reshaped(3, sets).transpose());
    Eigen::MatrixX3d moved = points;
    for (std::size_t k = 0; k < tied_.setOf.size(); ++k)
        moved.row(row(k)) += change.row(row(tied_.setOf[k]));
    return moved;
}

double MinChange::violation(const Eigen::MatrixX3d& change) const {
    double largest = 0;
    for (const LinearForm& equation : equations_) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            sum += equation.weights[k] * change.row(row(equation.unknowns[k]));
        largest = std::max(largest, sum.norm());
    }
    return largest;
}

/// The change of sets that is nearest to the given one among those that the equations allow.
Eigen::MatrixX3d MinChange::allowed(Eigen::MatrixX3d change) const {
    for (std::size_t k = 0; k < tied_.sizes.size(); ++k)
        change.row(row(k)) *= tied_.sizes[k];
    Eigen::MatrixX3d solution;
    allowed_.improve(change, Accuracy::rounding, solution);
    return solution.topRows(row(tied_.sizes.size()));
}

Eigen::VectorXd missingHeights(const std::vector<PlaneDemand>& demands, const Eigen::MatrixX3d& points) {
    Eigen::VectorXd result(row(demands.size()));
    for (Eigen::Index k = 0; const auto& [unknown, plane] : demands)
        result[k++] = plane.offset - points.row(row(unknown)).dot(vector(plane.normal));
    return result;
}

double largestDistance(const Eigen::MatrixX3d& points) {
    return points.rowwise().norm().maxCoeff();
}

} // namespace qm

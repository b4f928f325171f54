#include "bspline/solver/constrained_system.h"

#include "base/at.h"
#include "base/infinity.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

Eigen::VectorXd diagonalOf(Eigen::Index size, const Entries& entries) {
    Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(size);
    for (const auto& entry : entries)
        if (entry.row() == entry.col()) diagonal[entry.row()] += entry.value();
    return diagonal;
}

/// Appends the equations as rows below those of the form. Rows and constants are scaled so that each row is
/// of order one in the metric of the form's diagonal.
void appendEquations(const std::vector<LinearForm>& equations, const Eigen::VectorXd& diagonal,
                     Entries& entries, Eigen::MatrixX3d& constants) {
    for (std::size_t row = 0; row < equations.size(); ++row) {
        const LinearForm& form = equations[row];
        const auto index = static_cast<Eigen::Index>(row);
        const int place = static_cast<int>(diagonal.size() + index);
        entries.emplace_back(place, place, 0.0);
        double size = 0;
        for (std::size_t k = 0; k < form.unknowns.size(); ++k)
            size += form.weights[k] * form.weights[k] / diagonal[static_cast<Eigen::Index>(form.unknowns[k])];
        if (!(size > 0)) continue;
        for (std::size_t k = 0; k < form.unknowns.size(); ++k)
            entries.emplace_back(place, static_cast<int>(form.unknowns[k]),
                                 form.weights[k] / std::sqrt(size));
        constants.row(index) /= std::sqrt(size);
    }
}

/// Makes the matrix quasi-definite, so that any order of elimination works and equations may be redundant;
/// iterative refinement removes its effect.
constexpr double relaxation = 1e-12;

/// Smaller systems are solved before other threads have started.
constexpr Eigen::Index worthThreads = 10000;

} // namespace

ConstrainedSystem::ConstrainedSystem(std::size_t unknowns, Entries entries,
                                     const std::vector<LinearForm>& equations,
                                     const Eigen::MatrixX3d& constants, unsigned jobs)
    : unknowns_(static_cast<Eigen::Index>(unknowns)), constants_(constants) {
    const auto count = static_cast<Eigen::Index>(equations.size());
    if (constants_.rows() == 0) constants_.setZero(count, 3);
    appendEquations(equations, diagonalOf(unknowns_, entries), entries, constants_);
    const Eigen::Index whole = unknowns_ + count;
    jobs_ = whole < worthThreads ? 1 : jobs;
    Eigen::SparseMatrix<double> lower(whole, whole);
    lower.setFromTriplets(entries.begin(), entries.end());
    entries = Entries(); // gives the memory back
    matrix_ = lower.selfadjointView<Eigen::Lower>();
    for (Eigen::Index k = unknowns_; k < whole; ++k)
        lower.coeffRef(k, k) = -relaxation;
    factors_.emplace(lower, jobs_);
}

/// The residual of the right-hand side and of the equations' constants; the right-hand side itself if the
/// solution is empty.
Eigen::MatrixX3d ConstrainedSystem::residual(const Eigen::MatrixX3d& rightHandSide,
                                             const Eigen::MatrixX3d& solution) const {
    Eigen::MatrixX3d result(matrix_.rows(), 3);
    parallelForMany(at(matrix_.rows()), jobs_, [&](std::size_t k) {
        const auto row = static_cast<Eigen::Index>(k);
        Eigen::RowVector3d left = row < unknowns_ ? rightHandSide.row(row) : constants_.row(row - unknowns_);
        if (solution.rows() > 0)
            for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(matrix_, row); it; ++it)
                left -= it.value() * solution.row(it.col());
        result.row(row) = left;
    });
    return result;
}

void ConstrainedSystem::improve(const Eigen::MatrixX3d& rightHandSide, Accuracy accuracy,
                                Eigen::MatrixX3d& solution) const {
    constexpr double negligible = 1e-15;
    const int maxSteps = accuracy == Accuracy::draft ? 1 : 20;
    double before = infinity;
    for (int k = 0; k < maxSteps; ++k) {
        Eigen::MatrixX3d correction = factors_->solve(residual(rightHandSide, solution));
        // A correction that does not become smaller is rounding.
        const double change = correction.topRows(unknowns_).norm();
        if (change > 0.9 * before) break;
        if (solution.rows() == 0)
            solution = std::move(correction);
        else
            solution += correction;
        // Each step reduces the error by about the same factor: is the next one worth taking?
        const double next = k == 0 ? change : change * (change / before);
        before = change;
        if (next <= negligible * solution.topRows(unknowns_).norm()) break;
    }
}

double ConstrainedSystem::violation(const Eigen::MatrixX3d& solution) const {
    double largest = 0;
    for (Eigen::Index k = 0; k < constants_.rows(); ++k) {
        Eigen::RowVector3d left = constants_.row(k);
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator it(matrix_, unknowns_ + k); it; ++it)
            if (it.col() < unknowns_) left -= it.value() * solution.row(it.col());
        largest = std::max(largest, left.cwiseAbs().maxCoeff());
    }
    return largest;
}

} // namespace qm

#include "bspline/solver/constrained_system.h"

#include "base/at.h"
#include "base/infinity.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace qm {
namespace {

using Blocks = std::vector<Eigen::SparseMatrix<double>>;

/// The rows at which the blocks begin, and the number of all rows.
std::vector<int> firstRows(const Blocks& blocks) {
    std::vector<int> first{0};
    for (const auto& block : blocks)
        first.push_back(first.back() + static_cast<int>(block.rows()));
    return first;
}

Eigen::VectorXd diagonalOf(const Blocks& blocks) {
    const std::vector<int> first = firstRows(blocks);
    Eigen::VectorXd diagonal(first.back());
    for (std::size_t k = 0; k < blocks.size(); ++k)
        diagonal.segment(first[k], blocks[k].rows()) = blocks[k].diagonal();
    return diagonal;
}

/// Scales an equation and its constants so that it is of order one in the metric of the form's diagonal.
/// Nothing is left of an equation without weights.
template <class Constants>
LinearForm scaled(LinearForm equation, const Eigen::VectorXd& diagonal, Constants constants) {
    double size = 0;
    for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
        size += equation.weights[k] * equation.weights[k] /
                diagonal[static_cast<Eigen::Index>(equation.unknowns[k])];
    if (!(size > 0)) return {};
    for (double& weight : equation.weights)
        weight /= std::sqrt(size);
    constants /= std::sqrt(size);
    return equation;
}

/// The lower half of the whole matrix: the blocks, the equations as rows below them, and zeros on the rest of
/// the diagonal.
Eigen::SparseMatrix<double> lowerHalf(const Blocks& blocks, const std::vector<LinearForm>& equations,
                                      unsigned jobs) {
    const std::vector<int> first = firstRows(blocks);
    const int unknowns = first.back();
    const auto whole = unknowns + static_cast<int>(equations.size());
    Eigen::SparseMatrix<double> lower(whole, whole);
    const std::span begins(lower.outerIndexPtr(), at(whole) + 1);
    for (std::size_t k = 0; k < blocks.size(); ++k)
        for (int column = 0; column < blocks[k].cols(); ++column)
            begins[at(first[k] + column) + 1] =
                blocks[k].outerIndexPtr()[column + 1] - blocks[k].outerIndexPtr()[column];
    for (const LinearForm& equation : equations)
        for (const std::size_t unknown : equation.unknowns)
            ++begins[unknown + 1];
    std::fill(begins.begin() + unknowns + 1, begins.end(), 1);
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    lower.resizeNonZeros(begins.back());

    std::vector<int> next(begins.begin(), begins.end() - 1); // by column: the place of its next entry
    const auto add = [&](int row, int column, double value) {
        const int place = next[at(column)]++;
        lower.innerIndexPtr()[place] = row;
        lower.valuePtr()[place] = value;
    };
    parallelFor(blocks.size(), jobs, [&](std::size_t k) {
        for (int column = 0; column < blocks[k].cols(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator it(blocks[k], column); it; ++it)
                add(first[k] + static_cast<int>(it.row()), first[k] + column, it.value());
    });
    for (int row = unknowns; const LinearForm& equation : equations) {
        for (std::size_t k = 0; k < equation.unknowns.size(); ++k)
            add(row, static_cast<int>(equation.unknowns[k]), equation.weights[k]);
        add(row, row, 0);
        ++row;
    }
    return lower;
}

/// Makes the matrix quasi-definite, so that any order of elimination works and equations may be redundant;
/// iterative refinement removes its effect.
constexpr double relaxation = 1e-12;

/// Smaller systems are solved before other threads have started.
constexpr Eigen::Index worthThreads = 10000;

} // namespace

ConstrainedSystem::ConstrainedSystem(Blocks blocks, std::vector<LinearForm> equations,
                                     const Eigen::MatrixX3d& constants, unsigned jobs)
    : constants_(constants) {
    if (constants_.rows() == 0) constants_.setZero(static_cast<Eigen::Index>(equations.size()), 3);
    const Eigen::VectorXd diagonal = diagonalOf(blocks);
    unknowns_ = diagonal.size();
    for (Eigen::Index row = 0; LinearForm & equation : equations)
        equation = scaled(std::move(equation), diagonal, constants_.row(row++));
    jobs_ = unknowns_ + constants_.rows() < worthThreads ? 1 : jobs;
    Eigen::SparseMatrix<double> lower = lowerHalf(blocks, equations, jobs_);
    blocks = {}; // gives the memory back
    equations = {};
    matrix_ = lower.selfadjointView<Eigen::Lower>();
    for (Eigen::Index k = unknowns_; k < lower.cols(); ++k)
        lower.valuePtr()[lower.outerIndexPtr()[k]] = -relaxation;
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

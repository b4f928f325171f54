#include "bspline/fitting/constrained_system.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <limits>

namespace qm {

struct ConstrainedSystem::Factors {
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt;

    /// The factors are read once for all three columns, which Eigen reads once for each: that takes most of
    /// the time.
    [[nodiscard]] Eigen::MatrixX3d solve(const Eigen::MatrixX3d& rightHandSide) const {
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
        Rows x = ldlt.permutationP() * rightHandSide;
        const auto& lower = ldlt.matrixL().nestedExpression();
        const int* starts = lower.outerIndexPtr();
        const int* rows = lower.innerIndexPtr();
        const double* values = lower.valuePtr();
        const int size = static_cast<int>(x.rows());
        for (int column = 0; column < size; ++column) {
            const Eigen::RowVector3d known = x.row(column);
            for (int k = starts[column]; k < starts[column + 1]; ++k)
                if (rows[k] > column) x.row(rows[k]) -= values[k] * known;
        }
        x.array().colwise() /= ldlt.vectorD().array();
        for (int column = size - 1; column >= 0; --column) {
            Eigen::RowVector3d sum = x.row(column);
            for (int k = starts[column]; k < starts[column + 1]; ++k)
                if (rows[k] > column) sum -= values[k] * x.row(rows[k]);
            x.row(column) = sum;
        }
        return ldlt.permutationPinv() * Eigen::MatrixX3d(x);
    }
};

namespace {

/// Equations with weights such that each is of order one in the metric of the form's diagonal; their
/// constants likewise.
Eigen::SparseMatrix<double> equationMatrix(const std::vector<LinearForm>& equations,
                                           const Eigen::VectorXd& diagonal, Eigen::MatrixX3d& constants) {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t row = 0; row < equations.size(); ++row) {
        const LinearForm& form = equations[row];
        double size = 0;
        for (std::size_t k = 0; k < form.unknowns.size(); ++k)
            size += form.weights[k] * form.weights[k] / diagonal[static_cast<Eigen::Index>(form.unknowns[k])];
        if (!(size > 0)) continue;
        for (std::size_t k = 0; k < form.unknowns.size(); ++k)
            entries.emplace_back(static_cast<int>(row), static_cast<int>(form.unknowns[k]),
                                 form.weights[k] / std::sqrt(size));
        constants.row(static_cast<Eigen::Index>(row)) /= std::sqrt(size);
    }
    Eigen::SparseMatrix<double> matrix(static_cast<Eigen::Index>(equations.size()), diagonal.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Makes the whole matrix quasi-definite, so that every order of elimination works and equations may depend
/// on one another; what it changes is mended by refinement.
constexpr double relaxation = 1e-12;

} // namespace

ConstrainedSystem::ConstrainedSystem(std::size_t unknowns, const std::vector<Eigen::Triplet<double>>& entries,
                                     const std::vector<LinearForm>& equations,
                                     const Eigen::MatrixX3d& constants)
    : factors_(std::make_unique<Factors>()), constants_(constants) {
    if (constants_.rows() == 0) constants_.setZero(static_cast<Eigen::Index>(equations.size()), 3);
    const auto size = static_cast<Eigen::Index>(unknowns);
    form_.resize(size, size);
    form_.setFromTriplets(entries.begin(), entries.end());
    equations_ = equationMatrix(equations, form_.diagonal(), constants_);

    const auto whole = size + equations_.rows();
    std::vector<Eigen::Triplet<double>> all;
    all.reserve(static_cast<std::size_t>(form_.nonZeros() + equations_.nonZeros() + equations_.rows()));
    const auto append = [&all](const Eigen::SparseMatrix<double>& matrix, Eigen::Index rowOffset) {
        for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
                all.emplace_back(static_cast<int>(it.row() + rowOffset), static_cast<int>(it.col()),
                                 it.value());
    };
    append(form_, 0);
    append(equations_, size);
    for (Eigen::Index k = size; k < whole; ++k)
        all.emplace_back(static_cast<int>(k), static_cast<int>(k), -relaxation);
    Eigen::SparseMatrix<double> matrix(whole, whole);
    matrix.setFromTriplets(all.begin(), all.end());
    factors_->ldlt.compute(matrix);
}

ConstrainedSystem::~ConstrainedSystem() = default;

void ConstrainedSystem::improve(const Eigen::MatrixX3d& rightHandSide, Accuracy accuracy,
                                Eigen::MatrixX3d& solution) const {
    constexpr double negligible = 1e-15;
    const int maxSteps = accuracy == Accuracy::draft ? 1 : 20;
    double before = std::numeric_limits<double>::infinity();
    const Eigen::Index size = form_.rows();
    const bool beginsWithNothing = solution.rows() == 0;
    if (beginsWithNothing) solution = Eigen::MatrixX3d::Zero(size + equations_.rows(), 3);
    for (int k = 0; k < maxSteps; ++k) {
        Eigen::MatrixX3d residual(solution.rows(), 3);
        residual.topRows(size) = rightHandSide;
        residual.bottomRows(equations_.rows()) = constants_;
        if (k > 0 || !beginsWithNothing) {
            const auto unknowns = solution.topRows(size);
            residual.topRows(size) -= form_.selfadjointView<Eigen::Lower>() * unknowns;
            residual.topRows(size) -= equations_.transpose() * solution.bottomRows(equations_.rows());
            residual.bottomRows(equations_.rows()) -= equations_ * unknowns;
        }
        const Eigen::MatrixX3d correction = factors_->solve(residual);
        // What does not become smaller is rounding.
        const double change = correction.topRows(size).norm();
        if (change > 0.9 * before) break;
        before = change;
        solution += correction;
        if (change <= negligible * solution.topRows(size).norm()) break;
    }
}

double ConstrainedSystem::violation(const Eigen::MatrixX3d& solution) const {
    if (constants_.rows() == 0) return 0;
    return (constants_ - equations_ * solution.topRows(form_.rows())).cwiseAbs().maxCoeff();
}

Eigen::MatrixX3d ConstrainedSystem::solve(const Eigen::MatrixX3d& rightHandSide) const {
    Eigen::MatrixX3d solution;
    improve(rightHandSide, Accuracy::rounding, solution);
    return solution.topRows(form_.rows());
}

} // namespace qm

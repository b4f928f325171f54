/// \file A quadratic form minimised under linear equations (docs/METHOD.md#smooth-fit): factors of a
/// quasi-definite matrix (docs/METHOD.md#vanderbei-1995) in an order that keeps them sparse
/// (docs/METHOD.md#amestoy-2004).
#pragma once

#include "bspline/fitting/sparse_factors.h"
#include "bspline/network/border_strip.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// How well a system is solved.
enum class Accuracy {
    draft,   ///< one step, good enough to go on from
    rounding ///< the equations hold up to rounding
};

/// Factorised once, solved for any number of right-hand sides.
class ConstrainedSystem {
public:
    /// \param entries    of the symmetric positive definite matrix, row >= column; equal places add up
    /// \param equations  every form is to be its constant; they may depend on one another
    /// \param constants  a row for every equation; without any row they are zero
    ConstrainedSystem(std::size_t unknowns, std::vector<Eigen::Triplet<double>> entries,
                      const std::vector<LinearForm>& equations, const Eigen::MatrixX3d& constants,
                      unsigned jobs);

    /// Makes a solution that of the minimum of x'Hx / 2 - x'b under the equations, for each column of b. They
    /// hold up to rounding, unless a draft will do.
    /// \param solution  where to begin, with the multipliers of the equations; empty to begin with nothing
    void improve(const Eigen::MatrixX3d& rightHandSide, Accuracy accuracy, Eigen::MatrixX3d& solution) const;

    /// By how much a solution, with or without multipliers, misses an equation, at most, in the metric of the
    /// form.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& solution) const;

private:
    [[nodiscard]] Eigen::MatrixX3d residual(const Eigen::MatrixX3d& rightHandSide,
                                            const Eigen::MatrixX3d& solution) const;

    Eigen::Index unknowns_;
    unsigned jobs_ = 1;
    Eigen::MatrixX3d constants_;                          ///< of the equations
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_; ///< of unknowns and multipliers, both halves
    std::optional<SparseFactors> factors_;
};

} // namespace qm

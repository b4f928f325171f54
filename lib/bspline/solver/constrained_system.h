/// \file Minimises a quadratic form under linear equations (docs/METHOD.md#smooth-fit): factorises a
/// quasi-definite matrix (docs/METHOD.md#vanderbei-1995) in an order that keeps the factors sparse
/// (docs/METHOD.md#amestoy-2004).
#pragma once

#include "bspline/solver/linear_form.h"
#include "bspline/solver/sparse_factors.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// The accuracy of a solution.
enum class Accuracy {
    draft,   ///< one step of refinement
    rounding ///< the equations hold up to rounding
};

/// A system that is factorised once and solved for any number of right-hand sides.
class ConstrainedSystem {
public:
    /// \param blocks     along the diagonal of the symmetric positive definite matrix: the lower half of each,
    /// compressed
    /// \param equations  each form must equal its constant, and names an unknown once; equations may depend on
    /// one another
    /// \param constants  one row per equation; without rows they are zero
    ConstrainedSystem(std::vector<Eigen::SparseMatrix<double>> blocks, std::vector<LinearForm> equations,
                      const Eigen::MatrixX3d& constants, unsigned jobs);

    /// Turns a solution into the minimiser of x'Hx / 2 - x'b under the equations, for each column of b.
    /// \param solution  the values to start from, including the multipliers of the equations; may be empty
    void improve(const Eigen::MatrixX3d& rightHandSide, Accuracy accuracy, Eigen::MatrixX3d& solution) const;

    /// The largest violation of an equation by a solution, with or without multipliers, in the metric of the
    /// form.
    [[nodiscard]] double violation(const Eigen::MatrixX3d& solution) const;

private:
    [[nodiscard]] Eigen::MatrixX3d residual(const Eigen::MatrixX3d& rightHandSide,
                                            const Eigen::MatrixX3d& solution) const;

    Eigen::Index unknowns_;
    unsigned jobs_ = 1;
    Eigen::MatrixX3d constants_;                          ///< the right-hand sides of the equations
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_; ///< of unknowns and multipliers; both halves
    std::optional<SparseFactors> factors_;
};

} // namespace qm

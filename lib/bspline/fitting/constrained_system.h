/// \file A quadratic form minimised under linear equations (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/network/border_strip.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <vector>

namespace qm {

/// Factorised once, solved for any number of right-hand sides.
class ConstrainedSystem {
public:
    /// \param entries    of the symmetric positive definite matrix, row >= column; equal places add up
    /// \param equations  every form is to be zero; they may depend on one another
    ConstrainedSystem(std::size_t unknowns, const std::vector<Eigen::Triplet<double>>& entries,
                      const std::vector<LinearForm>& equations);
    ~ConstrainedSystem();

    /// The minimum of x'Hx / 2 - x'b under the equations, for each column of b. The equations hold up to
    /// rounding.
    [[nodiscard]] Eigen::MatrixX3d solve(const Eigen::MatrixX3d& rightHandSide) const;

private:
    struct Factors;
    std::unique_ptr<Factors> factors_;
    Eigen::SparseMatrix<double> form_; ///< its lower half
    Eigen::SparseMatrix<double> equations_;
};

} // namespace qm

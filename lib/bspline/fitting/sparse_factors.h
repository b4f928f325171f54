/// \file The factors L D L' of a sparse symmetric matrix, made and applied on several threads.
#pragma once

#include "bspline/fitting/supernodes.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace qm {

/// The multifrontal method (docs/METHOD.md#duff-1983), in an order that keeps the factors sparse
/// (docs/METHOD.md#amestoy-2004). Results do not depend on the number of threads.
class SparseFactors {
public:
    /// \param lower  the lower half of the matrix, row >= column; every principal minor is regular, as in
    ///               quasi-definite matrices
    SparseFactors(const Eigen::SparseMatrix<double>& lower, unsigned jobs);

    [[nodiscard]] Eigen::MatrixX3d solve(const Eigen::MatrixX3d& rightHandSide) const;

private:
    void forward(std::size_t supernode, Eigen::MatrixX3d& x, std::vector<Eigen::MatrixX3d>& passedOn) const;
    void backward(std::size_t supernode, Eigen::MatrixX3d& x) const;

    unsigned jobs_;
    Permutation order_;
    Supernodes plan_;
    std::vector<Eigen::MatrixXd> columns_; ///< by supernode: of L below the diagonal, which is D's
};

} // namespace qm

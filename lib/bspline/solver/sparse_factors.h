/// \file The factors L D L' of a sparse symmetric matrix, computed and applied on several threads.
#pragma once

#include "bspline/solver/supernodes.h"

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
    [[nodiscard]] Eigen::Map<const Eigen::MatrixXd> columnsOf(std::size_t supernode) const {
        const Supernode& node = plan_.nodes[supernode];
        return {values_.data() + starts_[supernode], node.height(), node.columns()};
    }

    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    using Columns = Eigen::MatrixX3d; ///< for what is added up along columns of L

    void forward(std::size_t number, Rows& x, Columns& own, Rows& passedOn) const;
    void backward(std::size_t number, Rows& x, Columns& own) const;

    unsigned jobs_;
    Permutation order_;
    Supernodes plan_;
    Eigen::Index maxHeight_ = 0;      ///< largest number of rows of a supernode
    std::vector<std::size_t> starts_; ///< by supernode: where its values begin, and the end of all
    Eigen::VectorXd values_;          ///< by supernode: columns of L below the diagonal, which holds D
};

} // namespace qm

/// \file The factors L D L' of a sparse symmetric matrix, made and applied on several threads.
#pragma once

#include "bspline/fitting/elimination_plan.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace qm {

/// Row by row (docs/METHOD.md#davis-2006), in an order that keeps the factors sparse
/// (docs/METHOD.md#amestoy-2004). Eigen does the same on one thread. Results do not depend on the threads.
class SparseFactors {
public:
    /// \param lower  the lower half of the matrix, row >= column; every principal minor is regular, as in
    ///               quasi-definite matrices
    SparseFactors(Eigen::SparseMatrix<double> lower, unsigned jobs);

    [[nodiscard]] Eigen::MatrixX3d solve(const Eigen::MatrixX3d& rightHandSide) const;

private:
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

    class Elimination;

    void forward(std::size_t part, Rows& x, Rows& sums) const;
    void backward(std::size_t part, Rows& x) const;

    unsigned jobs_;
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
    EliminationPlan plan_;
    std::vector<std::vector<int>> outside_; ///< by part: rows of the rest that it has entries in, ascending
    std::vector<std::size_t> inside_;       ///< by column: where entries in rows outside its part begin
    std::vector<int> rows_;                 ///< by entry; outside the part: as an index of its outside rows
    std::vector<double> values_;            ///< by entry
    std::vector<double> diagonal_;
};

} // namespace qm

/// \file The elimination tree of a sparse symmetric matrix (docs/METHOD.md#liu-1990).
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace qm {

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// Eliminating a column changes only the columns on its path to the root.
struct EliminationTree {
    static constexpr int none = -1;

    Permutation order;        ///< maps the matrix's columns to their places in the order of elimination
    std::vector<int> parent;  ///< by column; larger than the column, or `none` at a root
    std::vector<int> entries; ///< by column: number of entries of the factor below the diagonal
};

/// Finds an order that keeps the factor sparse (docs/METHOD.md#amestoy-2004) and in which every subtree is a
/// range of columns that ends with its root.
/// \param lower  the lower half of the matrix, row >= column; compressed
[[nodiscard]] EliminationTree eliminationTree(const Eigen::SparseMatrix<double>& lower);

} // namespace qm

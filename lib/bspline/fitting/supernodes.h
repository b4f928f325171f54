/// \file Groups of columns that are eliminated together, as one dense front (docs/METHOD.md#duff-1983).
#pragma once

#include "bspline/fitting/elimination_tree.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace qm {

/// Consecutive columns that have, nearly, the same rows in the factor: a dense trapezoid.
struct Supernode {
    int begin = 0; ///< of its columns, in the order of elimination
    int end = 0;
    std::vector<int> rows;              ///< below its columns, ascending
    int parent = EliminationTree::none; ///< the supernode that its rows contribute to
    std::vector<int> inParent; ///< by row: its place in the parent, whose columns come before its rows
    std::vector<int> children;

    [[nodiscard]] int columns() const { return end - begin; }
    [[nodiscard]] int height() const { return columns() + static_cast<int>(rows.size()); }
};

struct Supernodes {
    std::vector<Supernode> nodes; ///< children before their parents
    /// Numbers of supernodes, ascending. All parts but the last are whole subtrees, which need nothing of one
    /// another; the last is the top of the tree. The division depends on the matrix alone.
    std::vector<std::vector<int>> parts;
};

/// \param lower  the lower half of the matrix in the tree's order
[[nodiscard]] Supernodes planSupernodes(const EliminationTree& tree,
                                        const Eigen::SparseMatrix<double>& lower);

} // namespace qm

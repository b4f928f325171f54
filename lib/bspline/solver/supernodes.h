/// \file Groups of columns that are eliminated together as one dense front (docs/METHOD.md#duff-1983).
#pragma once

#include "base/at.h"
#include "bspline/solver/elimination_tree.h"

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace qm {

/// Consecutive columns whose rows in the factor are nearly the same: a dense trapezoid.
struct Supernode {
    int begin = 0; ///< its first column, in the order of elimination
    int end = 0;
    int firstRow = 0; ///< index of its first row below its columns, in the list of all supernodes' rows
    int rowEnd = 0;
    int parent = EliminationTree::none; ///< the supernode that its Schur complement is added to
    std::vector<int> children;

    [[nodiscard]] int columns() const { return end - begin; }
    [[nodiscard]] int height() const { return columns() + rowEnd - firstRow; }
};

struct Supernodes {
    std::vector<Supernode> nodes; ///< children before their parents
    std::vector<int> rows;        ///< of all supernodes one after another, ascending within each
    /// By row: its place in the parent's front, counting the parent's columns first.
    std::vector<int> inParent;
    /// Groups of supernodes, numbers ascending. All groups but the last are whole subtrees and independent of
    /// one another; the last is the top of the tree. The division depends on the matrix alone.
    std::vector<std::vector<int>> parts;

    [[nodiscard]] std::span<const int> rowsOf(const Supernode& node) const {
        return std::span(rows).subspan(at(node.firstRow), at(node.rowEnd - node.firstRow));
    }
    [[nodiscard]] std::span<const int> placesOf(const Supernode& node) const {
        return std::span(inParent).subspan(at(node.firstRow), at(node.rowEnd - node.firstRow));
    }
};

/// \param lower  the lower half of the matrix in the tree's order
[[nodiscard]] Supernodes planSupernodes(const EliminationTree& tree,
                                        const Eigen::SparseMatrix<double>& lower);

} // namespace qm

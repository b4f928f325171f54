/// \file The elimination tree of a sparse symmetric matrix (docs/METHOD.md#liu-1990), divided into parts that
/// need nothing of one another.
#pragma once

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace qm {

/// A column needs those below it in the tree alone, so that parts, whole subtrees each, are eliminated side
/// by side. The rest is the tree's top, which comes after all parts. How it is divided depends on the matrix
/// alone.
struct EliminationPlan {
    static constexpr int none = -1;

    std::vector<int> parent; ///< by column; none at a root
    std::vector<std::size_t>
        starts;            ///< by column: of its entries below the diagonal in the factor, and their end
    std::vector<int> part; ///< by column; the number of parts for the rest
    std::vector<std::vector<int>> columns; ///< by part, then of the rest; ascending

    [[nodiscard]] int rest() const { return static_cast<int>(columns.size()) - 1; }
};

/// \param upper  the upper half of the matrix, row <= column
EliminationPlan planElimination(const Eigen::SparseMatrix<double>& upper);

} // namespace qm

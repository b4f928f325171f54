/// \file Solving the relaxation of a node of the search tree and fixing columns by reduced costs
/// (docs/METHOD.md#optimum).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

enum class RelaxedNode {
    cut,       ///< no graph below the node is cheaper than the best known
    solved,    ///< the relaxation has a solution that agrees with the state
    unfinished ///< the solver failed or was stopped
};

/// Fixes every free column whose other value would make a graph too expensive.
/// \param values   a relaxed solution, to which the reduced costs belong
/// \param room     the cost from which graphs are too expensive less the bound of the solution; may be
/// infinite
/// \return false on a contradiction; the caller must then undo
bool fixByReducedCosts(ColumnState& columns, const ColumnValues& values, const ColumnValues& reducedCosts,
                       double room);

/// Solves the relaxation of the part's state, fixes columns by their reduced costs, and repeats this while
/// fixed columns contradict the solution.
/// \param bound  of the node; raised to the bound found
RelaxedNode relaxNode(PartSearch& part, double& bound);

} // namespace qm

/// \file The relaxation of a node of the search tree, with what its reduced costs fix
/// (docs/METHOD.md#optimum).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

enum class RelaxedNode {
    cut,       ///< nothing below the node is cheaper than what is known
    solved,    ///< the relaxation has a solution that agrees with the state
    unfinished ///< the solver has failed, or was stopped
};

/// Fixes every free column whose other value would make a graph too expensive.
/// \param values   of a relaxed solution, with their reduced costs
/// \param room     from the bound of that solution to the cost at which graphs are too expensive; may be infinite
/// \return false on a contradiction; then undo
bool fixByReducedCosts(ColumnState& columns, const ColumnValues& values, const ColumnValues& reducedCosts,
                       double room);

/// Solves the relaxation of the part's state, and again as long as what its reduced costs fix changes the
/// solution.
/// \param bound  of the node; grows
RelaxedNode relaxNode(PartSearch& part, double& bound);

} // namespace qm

/// \file What a search decides next: strong branching until pseudo-costs are reliable
/// (docs/METHOD.md#achterberg-2005).
#pragma once

#include "enumerate/optimum/part_search.h"
#include "enumerate/optimum/pseudo_costs.h"

namespace qm {

/// The two sides of a decision with their bounds; a side that is too expensive has an infinite one.
struct BranchingChoice {
    Decision decision; ///< without a state; without a variable if nothing is left to decide
    double boundIn = 0;
    double boundOut = 0;
};

class Branching {
public:
    /// \param part  outlives this
    explicit Branching(PartSearch& part) : part_(part), pseudoCosts_(part.formulation.costs) {}

    /// The column with a fractional relaxed value that promises the largest growth of the bound; any free
    /// variable if there is none.
    /// \param bound  of the node, whose relaxation has just been solved
    BranchingChoice choose(double bound);
    /// For relaxed solutions that are integral but no graphs, and where more than one graph is wanted.
    [[nodiscard]] BranchingChoice chooseAnyFree(double bound) const;

private:
    BranchingChoice probe(ColumnId column, double value, double bound, double& score);
    double probeSide(ColumnId column, ArcState side, double bound, double& growth);
    [[nodiscard]] Decision decisionOf(ColumnId column) const;

    PartSearch& part_;
    PseudoCosts pseudoCosts_;
};

} // namespace qm

/// \file Choice of the next decision of branch and bound: strong branching until pseudo-costs are reliable
/// (docs/METHOD.md#achterberg-2005).
#pragma once

#include "enumerate/optimum/part_search.h"
#include "enumerate/optimum/pseudo_costs.h"

namespace qm {

/// A decision and the bounds of its two sides; the bound of a side that is too expensive is infinite.
struct BranchingChoice {
    Decision decision; ///< without a value
    double boundIn = 0;
    double boundOut = 0;
};

class Branching {
public:
    /// \param part  must outlive this
    explicit Branching(PartSearch& part) : part_(part), pseudoCosts_(part.formulation.costs) {}

    /// Chooses the column with a fractional relaxed value that promises the largest growth of the bound; if
    /// no column is fractional, any free variable.
    /// \param bound  of the current node, whose relaxation has just been solved
    BranchingChoice choose(double bound);
    /// Chooses any free variable: for relaxed solutions that are integral but no graph, and for searches that
    /// want several graphs.
    [[nodiscard]] BranchingChoice chooseAnyFree(double bound) const;

private:
    BranchingChoice probe(ColumnId column, double value, double bound, double& score);
    double probeSide(ColumnId column, ArcState side, double bound, double& growth);
    [[nodiscard]] Decision decisionOf(ColumnId column) const;

    PartSearch& part_;
    PseudoCosts pseudoCosts_;
};

} // namespace qm

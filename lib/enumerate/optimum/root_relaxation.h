/// \file What the relaxation says of the root of a search tree, kept to fix more there with every better
/// graph (docs/METHOD.md#optimum).
#pragma once

#include "enumerate/optimum/part_search.h"

#include <limits>

namespace qm {

/// Fixes every free column whose other value would make a graph too expensive.
/// \param values   of a relaxed solution, with their reduced costs
/// \param room     from the bound of that solution to the cost at which graphs are too expensive; may be infinite
/// \return false on a contradiction; then undo
bool fixByReducedCosts(ColumnState& columns, const ColumnValues& values, const ColumnValues& reducedCosts,
                       double room);

/// The root of the search of one part: its state, and the last relaxed solution there.
class RootRelaxation {
public:
    explicit RootRelaxation(PartSearch& part) : part_(part), state_(part.columns.mark()) {}

    [[nodiscard]] bool isKnown() const { return !values_.empty(); }
    /// Takes the state for the root's, and the solution that the relaxation has just found for that of the
    /// root.
    void remember(double bound);
    /// Brings the root's state back.
    void restore() { part_.columns.undo(state_); }
    /// A better graph lets more be fixed at the root, for good.
    /// \return false if nothing cheaper is left
    bool tighten();
    /// Solves the tightened root again, in few iterations or not at all.
    [[nodiscard]] Relaxation::Result solveAgain();

private:
    PartSearch& part_;
    ColumnState::Mark state_;
    double bound_ = 0; ///< with values and reduced costs
    ColumnValues values_;
    ColumnValues reducedCosts_;
    Relaxation::Basis basis_;
    double cutoff_ = std::numeric_limits<double>::infinity(); ///< at the last tightening
};

} // namespace qm

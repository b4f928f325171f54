/// \file The data shared by all searches for graphs in one independent part of a problem.
#pragma once

#include "base/control.h"
#include "enumerate/optimum/part_cost.h"
#include "enumerate/optimum/part_options.h"
#include "enumerate/relaxation/column_state.h"
#include "enumerate/relaxation/relaxation.h"
#include "enumerate/state/incumbents.h"

#include <vector>

namespace qm {

/// A part of a problem, its relaxation, and the best graphs found so far.
struct PartSearch {
    /// \param variables  the free variables of the part
    PartSearch(SearchState& state, std::vector<VariableId> variables, const PartOptions& options,
               const Control& control);
    PartSearch(const PartSearch&) = delete;
    PartSearch& operator=(const PartSearch&) = delete;

    /// The value of a variable in the last relaxed solution.
    [[nodiscard]] double present(VariableId variable) const;
    [[nodiscard]] bool allDecided() const;
    /// The simplex method's work so far, that of searches within this one included.
    [[nodiscard]] std::size_t work() const { return workElsewhere + relaxation.work(); }
    /// Whether to end with what is known: the limit of work is reached, or the caller asks for it.
    [[nodiscard]] bool isOver() const { return work() >= options.work || control.stopRequested(); }
    /// Offers the current state, in which every variable is decided, as a graph.
    void recordLeaf();

    SearchState& state;
    std::vector<VariableId> variables;
    PartCost cost;
    PartOptions options;
    const Control& control;
    Incumbents incumbents; ///< full assignments, of which only the part's variables count
    Formulation formulation;
    ColumnState columns;
    Relaxation relaxation;
    std::size_t workElsewhere = 0; ///< of relaxations before this one, and of searches within this one
};

} // namespace qm

/// \file What the searches for graphs in one independent part of a search problem have in common.
#pragma once

#include "base/control.h"
#include "enumerate/optimum/column_state.h"
#include "enumerate/optimum/part_cost.h"
#include "enumerate/optimum/relaxation.h"
#include "enumerate/state/incumbents.h"

#include <functional>
#include <limits>
#include <vector>

namespace qm {

/// What a search of one part is to find.
struct PartOptions {
    std::size_t best = 1;
    double maxCost = std::numeric_limits<double>::infinity(); ///< of the part's variables
    double gap = 0;
    std::size_t nodes = 20'000'000; ///< of the search tree, at most: what memory allows
    std::size_t hard = 1500; ///< variables from which on early graphs are looked for by smaller searches
    std::size_t cut = 300;   ///< variables from which on cuts of the relaxation are looked for
    /// Variables from which on the relaxation begins near an optimum found by gradients.
    std::size_t large = std::numeric_limits<std::size_t>::max();
    /// Makes a graph cheaper if it can; `relaxed` are the values of the part's variables, in their order.
    std::function<Assignment(const Assignment& graph, const std::vector<double>& relaxed)> polish = {};
};

/// A part with its relaxation and the best graphs found so far.
struct PartSearch {
    /// \param variables  the free variables of the part
    PartSearch(SearchState& state, std::vector<VariableId> variables, const PartOptions& options,
               const Control& control);
    PartSearch(const PartSearch&) = delete;
    PartSearch& operator=(const PartSearch&) = delete;

    /// A variable's value in the last relaxed solution.
    [[nodiscard]] double present(VariableId variable) const;
    [[nodiscard]] bool allDecided() const;
    /// Offers the state, in which all is decided, as a graph.
    void recordLeaf();

    SearchState& state;
    std::vector<VariableId> variables;
    PartCost cost;
    PartOptions options;
    const Control& control;
    Incumbents incumbents; ///< full assignments, of which only the part's variables mean anything
    Formulation formulation;
    ColumnState columns;
    Relaxation relaxation;
};

} // namespace qm

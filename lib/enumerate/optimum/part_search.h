/// \file The data shared by all searches for graphs in one independent part of a problem.
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

/// The task and the limits of the search of one part.
struct PartOptions {
    std::size_t best = 1;
    double maxCost = std::numeric_limits<double>::infinity(); ///< of the part's variables and corners
    double gap = 0;
    std::size_t nodes = 20'000'000; ///< limit of the search tree; the default is what fits into memory
    std::size_t hard = 1500; ///< from this number of variables on, smaller searches look for early graphs
    std::size_t cut = 300;   ///< from this number of variables on, cuts are added to the relaxation
    /// From this number of variables on, the relaxation begins near an optimum found by gradients.
    std::size_t large = std::numeric_limits<std::size_t>::max();
    /// Returns a graph that is at most as expensive; `relaxed` holds the values of the part's variables in
    /// their order.
    std::function<Assignment(const Assignment& graph, const std::vector<double>& relaxed)> polish = {};
};

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
};

} // namespace qm

/// \file Random search problems with many of their graphs: what relaxations and rows are tried on.
#pragma once

#include "enumerate/state/assignment.h"
#include "enumerate/state/search_state.h"

#include <optional>
#include <vector>

namespace qm::testing {

/// A whole mesh as a search problem.
struct RandomProblem {
    ArcGraph graph;
    std::vector<double> costs; ///< of arcs
    std::optional<Problem> problem;
    std::vector<Assignment> graphs; ///< all, or the first 300
};

/// \return nothing if what was drawn is no mesh
[[nodiscard]] std::optional<RandomProblem> randomProblem(unsigned number);

[[nodiscard]] std::vector<VariableId> freeVariables(const SearchState& state);

} // namespace qm::testing

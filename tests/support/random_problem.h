/// \file Random search problems and many of their graphs, for tests of relaxations and rows.
#pragma once

#include "enumerate/state/assignment.h"
#include "enumerate/state/search_state.h"

#include <optional>
#include <vector>

namespace qm::test {

/// A whole mesh as a search problem.
struct RandomProblem {
    ArcGraph graph;
    IdVector<ArcId, double> costs; ///< of every arc
    std::optional<Problem> problem;
    std::vector<Assignment> graphs; ///< all, or the first 300
};

/// \return nothing if the random choice is no mesh
[[nodiscard]] std::optional<RandomProblem> randomProblem(unsigned number);

[[nodiscard]] std::vector<VariableId> freeVariables(const SearchState& state);

} // namespace qm::test

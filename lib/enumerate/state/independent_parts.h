/// \file Parts of a search problem that share no rule.
#pragma once

#include "enumerate/state/search_state.h"

#include <vector>

namespace qm {

/// Groups the free variables of a list so that no rule involves two groups. Each group is ascending, and
/// groups are ordered by their first variables. Time is linear in the chains and crossings of the variables.
/// \param variables  ascending; no rule may tie a free variable of the list to a free variable outside it
[[nodiscard]] std::vector<std::vector<VariableId>> independentParts(const SearchState& state,
                                                                    const std::vector<VariableId>& variables);

/// The same for all variables of the problem.
[[nodiscard]] std::vector<std::vector<VariableId>> independentParts(const SearchState& state);

} // namespace qm

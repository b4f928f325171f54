/// \file Parts of a search problem that have no rule in common.
#pragma once

#include "enumerate/state/search_state.h"

#include <vector>

namespace qm {

/// Groups the free ones among some variables so that no rule involves two groups. Each group is ascending,
/// and groups are ordered by their first variables. Time is linear in the chains and crossings of the
/// variables.
/// \param variables ascending; no rule ties a free one of them to a free variable that is not among them
[[nodiscard]] std::vector<std::vector<VariableId>> independentParts(const SearchState& state,
                                                                    const std::vector<VariableId>& variables);

/// The same for all variables of the problem.
[[nodiscard]] std::vector<std::vector<VariableId>> independentParts(const SearchState& state);

} // namespace qm

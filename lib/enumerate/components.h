/// \file Parts of a search problem that have no rule in common.
#pragma once

#include "enumerate/search_state.h"

#include <vector>

namespace qm {

/// The free variables, grouped so that no rule involves two groups; each group ascending, ordered by first
/// variable.
[[nodiscard]] std::vector<std::vector<int>> independentParts(const SearchState& state);

} // namespace qm

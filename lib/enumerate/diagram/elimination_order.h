/// \file The order in which a decision diagram decides, chosen such that few decisions matter for long.
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"

#include <optional>
#include <vector>

namespace qm {

/// One decision: whether a variable is in, or, where two tracks cross, whether a chain is covered from end to
/// end.
struct Step {
    VariableId variable; ///< none if the step is about a chain
    ChainId chain;
    CrossingId crossing; ///< with a chain: where all arcs around it have been decided
};

/// Has every free variable once, and after the arcs of a crossing the chains there whose cover is open, so
/// that rule 4 is settled at once. Crossings follow one another such that the next one always leaves the
/// fewest variables and chains with something decided and something undecided around them; the best of many
/// starts.
/// \return nothing if no order promises a diagram that memory could hold, or `control.stopRequested`
[[nodiscard]] std::optional<std::vector<Step>> eliminationOrder(const SearchState& state,
                                                                const Control& control = {});

} // namespace qm

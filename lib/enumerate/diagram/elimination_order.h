/// \file The order in which a decision diagram decides, chosen to keep the border of the diagram narrow.
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"

#include <optional>
#include <vector>

namespace qm {

/// One decision: whether a variable is in, or, at a crossing of two tracks, whether a chain is covered from
/// end to end.
struct Step {
    VariableId variable; ///< none if the step decides the cover of a chain
    ChainId chain;
    CrossingId crossing; ///< with a chain: the crossing whose arcs have just been decided
};

/// Contains every free variable once, and after the arcs of a crossing the chains there whose cover is open,
/// so that rule 4 is settled at once. The next crossing is always the one that leaves the fewest variables
/// and chains decided in part; of many starting points, the one with the best order is taken.
/// \return nothing if no order promises a diagram that fits into memory, or if `control.stopRequested`
[[nodiscard]] std::optional<std::vector<Step>> eliminationOrder(const SearchState& state,
                                                                const Control& control = {});

} // namespace qm

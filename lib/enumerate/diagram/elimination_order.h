/// \file In which order a decision diagram decides: such that little of what is decided matters later.
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"

#include <optional>
#include <vector>

namespace qm {

/// One decision: whether a variable is in, or, where two tracks cross, whether a chain is covered from end to
/// end.
struct Step {
    int variable = -1; ///< of the problem; -1 if the step is about a chain
    int chain = -1;
    int crossing = -1; ///< with a chain: where all arcs around it have been decided
};

/// Every free variable once, and every open chain after the arcs of each of its crossings, so that rule 4 is
/// settled there and then. Crossing by crossing, always the neighbour that leaves the fewest items with one
/// end behind and one ahead; from the best of many starts.
/// \return nothing if no order promises a diagram that memory could hold, or `control.stopRequested`
[[nodiscard]] std::optional<std::vector<Step>> eliminationOrder(const SearchState& state,
                                                                const Control& control = {});

} // namespace qm

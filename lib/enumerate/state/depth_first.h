/// \file Visits every motorcycle graph exactly once, depth first with undo (docs/METHOD.md#search-problem).
#pragma once

#include "base/control.h"
#include "enumerate/state/search_state.h"

#include <functional>

namespace qm {

/// Calls `visit` with the full assignment of every graph whose cost is at most `costLimit()`, which is called
/// at every step, so that the limit may fall during the search. Memory is linear in the problem, whatever the
/// number of graphs.
/// \return false if `visit` returned false or `control.stopRequested` returned true; either ends the search
bool forEachAssignment(const Problem& problem, const std::function<double()>& costLimit,
                       const std::function<bool(const SearchState&)>& visit, const Control& control = {});

} // namespace qm

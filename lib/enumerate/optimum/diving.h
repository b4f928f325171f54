/// \file Early graphs by diving: fixes what the relaxed solution is sure of, and solves again or searches the
/// rest (docs/METHOD.md#early-graphs).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

/// Fixes columns that are nearly 1 and solves again, until the solution is integral or too expensive.
void dive(PartSearch& part);

/// Dives until few enough variables are fractional for a search. If the search finds no graph, because the
/// values taken over contradict each other, the dive goes on.
void diveToRest(PartSearch& part);

/// Searches the variables on which the relaxed solution and the best graph disagree: relaxation induced
/// neighbourhood search (docs/METHOD.md#danna-2005).
void searchNearby(PartSearch& part);

} // namespace qm

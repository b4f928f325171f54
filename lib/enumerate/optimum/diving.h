/// \file Early graphs by fixing the integral part of the relaxed solution and searching the rest
/// (docs/METHOD.md#early-graphs).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

/// Fixes the columns that are nearly 1 and solves again, until the solution is integral or too expensive.
void dive(PartSearch& part);

/// The same, until what the relaxed solution leaves in doubt is small enough to be searched. Values that the
/// relaxed solution is sure of may contradict each other; then it goes on.
void diveToRest(PartSearch& part);

/// Searches the variables on which the relaxed solution and the best graph disagree: relaxation induced
/// neighbourhoods (docs/METHOD.md#danna-2005).
void searchNearby(PartSearch& part);

} // namespace qm

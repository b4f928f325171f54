/// \file Early graphs from a relaxed solution: by rounding, and by diving, which fixes what the solution is
/// sure of and solves again or searches the rest (docs/METHOD.md#early-graphs).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

/// Offers the relaxed solution as a graph if it is integral and obeys all rules.
bool acceptIntegral(PartSearch& part);

/// Rounds the relaxed solution to the nearer value; for T-meshes also all fractions up, which always gives a
/// T-mesh.
void roundRelaxed(PartSearch& part);

/// Makes two graphs without the relaxation, which may take long: one with as many arcs as fit, one with few.
void guessGraphs(PartSearch& part);

/// Fixes columns that are nearly 1 and solves again, until the solution is integral or too expensive.
void dive(PartSearch& part);

/// Dives until few enough variables are fractional for a search. If the search finds no graph, because the
/// values taken over contradict each other, the dive goes on.
void diveToRest(PartSearch& part);

/// Searches the variables on which the relaxed solution and the best graph disagree: relaxation induced
/// neighbourhood search (docs/METHOD.md#danna-2005).
void searchNearby(PartSearch& part);

} // namespace qm

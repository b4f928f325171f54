/// \file Early graphs: the relaxed solution, rounded.
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

/// Takes the relaxed solution if it is integral and obeys all rules.
bool acceptIntegral(PartSearch& part);

/// Rounds the relaxed solution to the nearer value, and again up: without rule 3 the latter always gives a
/// graph.
void roundRelaxed(PartSearch& part);

/// A graph without asking the relaxation, however long that may take: as much as fits, or as little.
void guessGraphs(PartSearch& part);

} // namespace qm

/// \file Early graphs by rounding the relaxed solution (docs/METHOD.md#early-graphs).
#pragma once

#include "enumerate/optimum/part_search.h"

namespace qm {

/// Takes the relaxed solution if it is integral and obeys all rules.
bool acceptIntegral(PartSearch& part);

/// Rounds the relaxed solution to the nearer value, and again up: without rule 3 the latter always gives a
/// graph.
void roundRelaxed(PartSearch& part);

/// Two graphs without the relaxation, which may take long: one with as many arcs as fit, one with as few.
void guessGraphs(PartSearch& part);

} // namespace qm

/// \file Early graphs by rounding the relaxed solution (docs/METHOD.md#early-graphs).
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

} // namespace qm

/// \file Rule 2 (docs/METHOD.md#arc-rules): which arcs may meet at an ordinary junction.
#pragma once

#include "enumerate/state/partial_assignment.h"

namespace qm {

/// Draws the conclusions of rule 2 at a crossing.
/// \return false on a contradiction
[[nodiscard]] bool concludeAround(const Crossing& crossing, PartialAssignment& assignment);

} // namespace qm

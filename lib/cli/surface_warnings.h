/// \file What somebody should know of surfaces before using them, on standard error.
#pragma once

#include "bspline/splines/surfaces.h"

namespace qm {

class Tool;

/// Patches are farther apart than what STEP takes for one point.
void warnOfGaps(const Tool& tool, const Surfaces& surfaces);

/// Pieces of patches may fold over: how many, and where in the patch that has more than any other.
void warnOfFolds(const Tool& tool, const Surfaces& surfaces);

} // namespace qm

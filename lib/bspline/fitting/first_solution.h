/// \file The first solution of a fit: with few knots, and without folds.
#pragma once

#include "bspline/fitting/fit_state.h"

#include <functional>

namespace qm {

/// Solves for all patches with the fewest knots that are likely to suffice. Patches that fold with so few get
/// more at once, because folded patches seldom unfold, and knots that are not needed can be removed.
/// \param state            without knots and patches
/// \param slides           number of times that the targets slide in between
/// \param isStopRequested  patches that fold remain folded once it returns true
void solveFirst(FitState& state, int slides, const std::function<bool()>& isStopRequested);

} // namespace qm

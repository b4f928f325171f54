/// \file Surfaces that are exactly smooth across all smooth borders, with as few knots as the tolerance
/// allows (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/control.h"
#include "bspline/fitting/fit_options.h"
#include "bspline/fitting/fit_problem.h"

#include <vector>

namespace qm {

/// Fits patches that share their borders and are G1 across all borders that are not creases. The tolerance is
/// missed where the shortest knot intervals (see `MinInterval`) do not suffice, or where bicubics cannot
/// follow the reference, or if `control.stopRequested`, which ends the search for knots after the round it is
/// in. Patches that the verification finds too far away are fitted more closely. A model that is farther from
/// the origin than it is large is moved there meanwhile: otherwise its coordinates would leave too few digits
/// for patches to meet exactly.
/// \return one patch per segment, in their order
[[nodiscard]] std::vector<Patch> fitSmooth(const FitProblem& problem, const SmoothFitOptions& options,
                                           const Control& control);

} // namespace qm

/// \file The fit of models that lie far from the origin.
#pragma once

#include "bspline/fitting/smooth_fit.h"

namespace qm {

/// Calls `fitSmooth`; a model that is farther from the origin than it is large is moved to the origin
/// meanwhile. Otherwise its coordinates would leave too few digits for patches to meet exactly.
[[nodiscard]] std::vector<Patch> fitCentred(const FitProblem& problem, const SmoothFitOptions& options,
                                            const Control& control);

} // namespace qm

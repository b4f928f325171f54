/// \file One attempt at a fit: rounds of placing knots and fitting, verified and mended.
#pragma once

#include "base/control.h"
#include "bspline/fitting/fit_options.h"
#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/fitted.h"

#include <optional>
#include <vector>

namespace qm {

/// What an attempt begins with instead of the fewest knots.
struct Restart {
    const Fitted& from;
    std::vector<bool> isSoft; ///< by patch: begins anew, and follows the reference more closely at the cost
                              ///< of fairness
};

/// Fits until the tolerance is kept with as few knots as possible, verifies the result, and mends what the
/// verification finds, at most `options.verifications` times.
/// \param restart  none for the first attempt
/// \param isLast   whether no other attempt follows, so that even mending that leads astray is tried
/// \return the result that was verified as the nearest
[[nodiscard]] Fitted attemptFit(const FitProblem& problem, const SmoothFitOptions& options,
                                const std::optional<Restart>& restart, bool isLast, const Control& control);

} // namespace qm

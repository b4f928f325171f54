/// \file Removes knots that a fit does not need.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_errors.h"
#include "bspline/fitting/lattice/normal_limits.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Removes chosen knots, never two in a row. A knot goes if the jump of the third derivative at it predicts
/// that without it all errors around, and the slopes relative to their limits, stay a little below 1. The
/// prediction is not certain, so the fit must be made and measured again.
/// \return what was removed
[[nodiscard]] std::vector<PatchKnot> removeKnots(const std::vector<FitLattice>& lattices,
                                                 const std::vector<NormalLimits>& limits,
                                                 const std::vector<Patch>& patches,
                                                 const std::vector<PatchErrors>& errors, double tolerance,
                                                 KnotPlan& plan);

} // namespace qm

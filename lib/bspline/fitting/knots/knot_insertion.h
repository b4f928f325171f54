/// \file Where a fit is too far from the reference, it gets knots, and tangent ratios that end sooner.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_errors.h"
#include "bspline/network/stretch_map.h"

#include <vector>

namespace qm {

/// Divides the knot intervals in which an error is above 1, and halves the reach of tangent ratios beside
/// such places. Where the largest error is on a border, the border is divided, on the side with the longer
/// interval: only knots that both sides have bring it nearer. Patches whose errors are far below those of
/// their neighbours are left for later, as these may be the cause.
/// \param spaces  of the fit that has the errors
/// \return false if there was nothing to do, or nothing could be done
[[nodiscard]] bool refine(const std::vector<FitLattice>& lattices, const StretchMap& map,
                          const std::vector<PatchSpace>& spaces, const std::vector<PatchErrors>& errors,
                          KnotPlan& plan);

} // namespace qm

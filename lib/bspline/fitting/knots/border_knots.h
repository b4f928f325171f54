/// \file Knots that the patches on both sides of a border have in common.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/normal_limits.h"

#include <vector>

namespace qm {

/// Into a plan with the knots that each patch needs by itself: inserts knots at grid lines until those that
/// both sides of a border have are close enough for single cubics between them to follow the border. Only
/// these serve the border; knots that one side has already are preferred.
/// \param lattices    by patch, of equal steps
/// \param tolerances  by patch: how far a cubic may be away from its borders
void insertBorderKnots(const std::vector<FitLattice>& lattices, const std::vector<NormalLimits>& limits,
                       const std::vector<double>& tolerances, KnotPlan& plan);

} // namespace qm

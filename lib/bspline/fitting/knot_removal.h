/// \file Knots that a fit can do without.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/knot_plan.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/fitting/normal_limits.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Removes chosen knots, no two that follow one another, for which the jump of the third derivative tells
/// that the errors, and the slopes in what their limits allow, would stay below `limit` without them. What
/// jumps tell is not certain: the fit is to be made and measured anew.
/// \return how many
std::size_t removeKnots(const std::vector<FitLattice>& lattices, const std::vector<NormalLimits>& limits,
                        const std::vector<Patch>& patches, const std::vector<PatchErrors>& errors,
                        double tolerance, double limit, KnotPlan& plan);

} // namespace qm

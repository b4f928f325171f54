/// \file Where a fit is too far from the reference, it gets knots, and tangent ratios that end sooner.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/knot_plan.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/network/stretch_map.h"

#include <vector>

namespace qm {

/// Divides the knot intervals in which an error is above 1, and halves the reach of tangent ratios beside
/// such places; along a border the interval of the side that has the longer one, for only knots of both sides
/// serve the border. Places with errors far below their neighbourhood's are left for later: they may be due
/// to those.
/// \param spaces  of the fit that has the errors
/// \return false if there was nothing to do, or nothing could be done
[[nodiscard]] bool refine(const Layout& layout, const std::vector<FitLattice>& lattices,
                          const StretchMap& map, const std::vector<PatchSpace>& spaces,
                          const std::vector<PatchErrors>& errors, KnotPlan& plan);

} // namespace qm

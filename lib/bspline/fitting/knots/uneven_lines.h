/// \file Grid lines at which the widths of quads change at once.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/reference/lattice/reference_grid.h"

#include <vector>

namespace qm {

/// The inner grid lines of every patch beside which quads are, on average, more than five times as wide on
/// one side as on the other. A spline of uniform parameters crosses them at one speed, and with one second
/// derivative, unless it has a double knot there; then the second derivatives may differ, too.
[[nodiscard]] KnotLists unevenLines(const std::vector<ReferenceGrid>& grids);

} // namespace qm

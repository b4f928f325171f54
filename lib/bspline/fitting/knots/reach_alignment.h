/// \file Tangent ratios end at the same knots where that takes fewer control points.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"

namespace qm {

/// Lets tangent ratios end where others end in the same patches. Each end takes a double knot across both
/// patches of its border, which all that end there share. So every end moves to where the patches have the
/// fewest control points, not farther from its vertex than twice as far as it is, nor nearer than a quarter.
void alignReaches(KnotPlan& plan);

} // namespace qm

/// \file Tangent ratios end at the same knots where that takes fewer control points.
#pragma once

#include "bspline/fitting/knots/even_vertices.h"
#include "bspline/fitting/knots/knot_plan.h"

#include <vector>

namespace qm {

/// Lets tangent ratios end where others end in the same patches. Each end takes a double knot across both
/// patches of its border, which all that end there share. So every end moves to where the patches have the
/// fewest control points, not farther from its vertex than twice as far as it is, nor nearer than a quarter.
///
/// Before that, reaches around even vertices become short enough for the borders there. Those that others
/// make up for grow again, to what they were or to where others end.
/// \param vertices  the even ones
/// \param allowed   how far their borders may be from the reference
void alignReaches(KnotPlan& plan, const std::vector<EvenVertex>& vertices = {}, double allowed = 0);

} // namespace qm

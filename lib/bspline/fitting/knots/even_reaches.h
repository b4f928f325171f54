/// \file Shorter reaches of tangent ratios around even vertices.
#pragma once

#include "bspline/fitting/knots/even_vertices.h"
#include "bspline/fitting/knots/knot_plan.h"

#include <vector>

namespace qm {

/// Where the borders of an even vertex cannot be as near to the reference as allowed, shortens the reaches of
/// all of them to the longest one, in common to all, with which they can.
/// \param allowed  the error of borders
void shortenAtEvenVertices(const std::vector<EvenVertex>& vertices, double allowed, KnotPlan& plan);

} // namespace qm

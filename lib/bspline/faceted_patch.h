/// \file A patch that follows its quads exactly.
#pragma once

#include "bspline/patch_fit.h"

namespace qm {

/// The quads themselves, as a spline with triple knots at every line of the grid, but with the given border.
[[nodiscard]] Patch facetedPatch(const PatchFitInput& input);

} // namespace qm

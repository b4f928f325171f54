/// \file Moves the control points of plane patches into their planes.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/splines/surfaces.h"

#include <optional>
#include <vector>

namespace qm {

/// Moves all control points of the plane patches into their planes, and changes the patches around them as
/// little as the continuity equations require (docs/METHOD.md#plane-patches). Straight outlines are dropped
/// before planes.
/// \param flat    by patch; what turns out to contradict its neighbours is dropped from it
/// \param jobs    threads; the result does not depend on their number
/// \return whether a point was moved
bool flatten(const KnotPlan& plan, std::vector<std::optional<FlatPatch>>& flat, std::vector<Patch>& patches,
             unsigned jobs);

} // namespace qm

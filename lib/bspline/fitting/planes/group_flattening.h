/// \file Moves the control points of plane patches into their planes, group by group.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/fitting/planes/moving_groups.h"
#include "bspline/splines/surfaces.h"

#include <optional>
#include <vector>

namespace qm {

/// Makes the smallest change of a group's control points that moves those of plane patches into their planes.
/// Demands that contradict their neighbours are dropped, straight outlines before planes.
/// \param flat     by patch of the layout: what is wanted; becomes what could be had
/// \param patches  by patch of the layout
/// \return whether a point was moved; none is if all are where they are wanted, or if it is impossible
[[nodiscard]] bool flattenGroup(const MovingGroup& group, std::vector<std::optional<FlatPatch>>& flat,
                                std::vector<Patch>& patches);

/// Moves all control points of the plane patches into their planes, and changes the patches around them as
/// little as the continuity equations require (docs/METHOD.md#plane-patches): the same for all groups.
/// \param jobs  threads; the result does not depend on their number
/// \return whether a point was moved
bool flatten(const KnotPlan& plan, std::vector<std::optional<FlatPatch>>& flat, std::vector<Patch>& patches,
             unsigned jobs);

} // namespace qm

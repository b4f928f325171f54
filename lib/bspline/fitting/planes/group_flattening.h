/// \file Moves the plane patches of one group into their planes.
#pragma once

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

} // namespace qm

/// \file Which patches are solved for, while all others stay as they are.
#pragma once

#include "bspline/network/stretches.h"
#include "bspline/splines/patch_space.h"

#include <vector>

namespace qm {

/// The patches that have changed and `rings` rings of those around them; all if these have more than a share
/// of the control points.
/// \param changed   by patch
/// \param worthAll  this share
[[nodiscard]] std::vector<bool> freePatches(const std::vector<Stretch>& stretches,
                                            const std::vector<PatchSpace>& spaces,
                                            const std::vector<bool>& changed, int rings, double worthAll);

} // namespace qm

/// \file Which patches are solved for, while all others stay as they are.
#pragma once

#include "bspline/fitting/fit_options.h"
#include "bspline/network/border_strip.h"
#include "bspline/network/stretches.h"

#include <vector>

namespace qm {

/// Adds to a set of patches those that share a border with one of them, `rings` times.
[[nodiscard]] std::vector<bool> withNeighbours(const std::vector<Stretch>& stretches,
                                               std::vector<bool> patches, int rings);

/// The patches that have changed and those around them; all if that is most of them.
/// \param changed  by patch
[[nodiscard]] std::vector<bool> freePatches(const std::vector<Stretch>& stretches,
                                            const std::vector<PatchSpace>& spaces,
                                            const std::vector<bool>& changed,
                                            const SmoothFitOptions& options);

} // namespace qm

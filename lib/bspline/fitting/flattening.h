/// \file Putting plane patches into their planes.
#pragma once

#include "bspline/fitting/plane_patches.h"
#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_network.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <optional>
#include <vector>

namespace qm {

/// Puts all control points of such patches into their planes, and changes what is near as little as the
/// continuity equations demand (docs/METHOD.md#plane-patches). Planes that cannot all be had with those
/// around are left out.
/// \param spaces  of the patches
/// \param jobs  threads; the result does not depend on them
void flatten(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
             std::vector<std::optional<Plane>> planes, std::vector<Patch>& patches, unsigned jobs);

} // namespace qm

/// \file Patches that are plane because their reference is.
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <optional>
#include <vector>

namespace qm {

/// The points x with normal * x = offset.
struct Plane {
    Point normal; ///< unit
    double offset = 0;
};

/// The plane of every patch whose reference has one. Patches that are plane and meet smoothly share one.
/// \param tolerance  distance of the reference's points from it, at most
[[nodiscard]] std::vector<std::optional<Plane>> planesOf(const std::vector<ReferenceGrid>& reference,
                                                         const SmoothNetwork& network, double tolerance);

/// Puts all control points of such patches into their planes, and changes what is near as little as the
/// continuity equations demand (docs/METHOD.md#plane-patches).
/// \param spaces  of the patches
void flatten(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
             const std::vector<std::optional<Plane>>& planes, std::vector<Patch>& patches);

} // namespace qm

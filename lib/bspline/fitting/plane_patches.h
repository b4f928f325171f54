/// \file Patches that are plane because their reference is.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/reference_grid.h"

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

} // namespace qm

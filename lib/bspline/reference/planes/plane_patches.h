/// \file Patches that are plane because their reference is plane.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/reference/planes/plane.h"

#include <optional>
#include <vector>

namespace qm {

/// By patch: the plane of its reference, if it has one. Plane patches that meet smoothly share one plane.
/// \param tolerance  largest distance of the reference's points from a plane
[[nodiscard]] std::vector<std::optional<Plane>> planesOf(const std::vector<ReferenceGrid>& reference,
                                                         const SmoothNetwork& network, double tolerance);

} // namespace qm

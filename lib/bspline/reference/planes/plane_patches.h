/// \file Patches that are plane because their reference is plane.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/reference_grid.h"

#include <optional>
#include <vector>

namespace qm {

/// The points x with normal * x = offset.
struct Plane {
    Point normal; ///< unit
    double offset = 0;

    bool operator==(const Plane&) const = default;
};

/// Plane parts may be as thick as the coordinates of mesh files are rounded: a share of the diagonal.
constexpr double maxFlatness = 5e-6;

/// By patch: the plane of its reference, if it has one. Plane patches that meet smoothly share one plane.
/// \param tolerance  largest distance of the reference's points from a plane
[[nodiscard]] std::vector<std::optional<Plane>> planesOf(const std::vector<ReferenceGrid>& reference,
                                                         const SmoothNetwork& network, double tolerance);

} // namespace qm

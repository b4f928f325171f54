/// \file Plane patches, and straight parts of the outline of a mesh where these end.
#pragma once

#include "bspline/network/smooth_network.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/reference/planes/plane.h"
#include "layout/layout.h"

#include <array>
#include <optional>
#include <vector>

namespace qm {

/// What the control points of a plane patch must lie in (docs/METHOD.md#plane-patches).
struct FlatPatch {
    Plane plane;
    /// By side: where it is straight and nothing lies beyond it, the plane at right angles that holds it.
    std::array<std::optional<Plane>, 4> outlines;
};

/// By patch: its planes, if its reference is plane. Sides that continue each other along the outline share
/// one line.
/// \param tolerance  largest distance of the reference's points from a plane or a line
[[nodiscard]] std::vector<std::optional<FlatPatch>> flatPatches(const Layout& layout,
                                                                const std::vector<ReferenceGrid>& reference,
                                                                const SmoothNetwork& network,
                                                                double tolerance);

} // namespace qm

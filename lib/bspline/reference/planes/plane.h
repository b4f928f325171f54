/// \file A plane in space.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm {

/// The points x with normal * x = offset.
struct Plane {
    Point normal; ///< unit
    double offset = 0;

    bool operator==(const Plane&) const = default;

    /// Positive on the side that the normal points to.
    [[nodiscard]] double distance(const Point& at) const { return (normal | at) - offset; }
};

/// Plane parts may be as thick as the coordinates of mesh files are rounded: a share of the diagonal.
constexpr double maxFlatness = 5e-6;

/// Share of their smaller extent that plane parts may be thick.
constexpr double maxThickness = 1e-4;

} // namespace qm

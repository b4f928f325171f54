/// \file A cube, and the ball that it becomes.
#pragma once

#include "shape/quad_list.h"
#include "shape/true_surface.h"

namespace qm {

/// \param n  quads along an edge
[[nodiscard]] QuadList cubeShape(int n);

[[nodiscard]] TrueSurface cubeSurface();

/// A cube drawn onto the sphere of radius 1, in equal angles along its edges.
/// \param around  quads around the equator, even and at least 4; around the other axes there may be two fewer
[[nodiscard]] QuadList sphereShape(int around);
[[nodiscard]] TrueSurface sphereSurface();

} // namespace qm

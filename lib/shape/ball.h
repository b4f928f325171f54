/// \file A cube, and the ball that it becomes.
#pragma once

#include "shape/quad_list.h"

namespace qm {

/// \param n  quads along an edge
[[nodiscard]] QuadList cubeShape(int n);

/// A cube drawn onto the sphere, in equal angles along its edges.
[[nodiscard]] QuadList sphereShape(int n);

} // namespace qm

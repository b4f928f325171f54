/// \file The boundary of a triangulated surface.
#pragma once

#include "mesh/triangles.h"

#include <vector>

namespace qm {

struct BoundarySides {
    std::vector<bool> sides;  ///< 3 * f + k: the side from corner k of triangle f to the next; true if no
                              ///< other triangle has it
    std::vector<bool> points; ///< true at the ends of such sides
};

/// Finds the boundary in O(n log n) time.
[[nodiscard]] BoundarySides boundarySides(const Triangles& triangles);

} // namespace qm

/// \file Where a surface of triangles ends.
#pragma once

#include "mesh/triangles.h"

#include <vector>

namespace qm {

struct BoundarySides {
    std::vector<bool> sides; ///< 3 * f + k, from corner k of triangle f to the next: no other triangle has it
    std::vector<bool> points; ///< ends of such sides
};

/// In n log n time, whatever the triangles.
[[nodiscard]] BoundarySides boundarySides(const Triangles& triangles);

} // namespace qm

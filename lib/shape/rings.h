/// \file Shapes that grids make when opposite sides are joined.
#pragma once

#include "shape/quad_list.h"

namespace qm {

// n is the number of quads along the shortest way around the tube, divided by 4.

/// An open tube: an annulus, with no extraordinary vertex.
[[nodiscard]] QuadList tubeShape(int n);

/// A ring with no extraordinary vertex.
[[nodiscard]] QuadList torusShape(int n);

/// A ring whose lines wind around it like the threads of a screw, with a boss on its outside: the boss's
/// eight extraordinary vertices send out separatrices that wind around the ring many times.
[[nodiscard]] QuadList helixShape(int n);

} // namespace qm

/// \file Shapes that grids make when opposite sides are joined.
#pragma once

#include "shape/quad_list.h"
#include "shape/true_surface.h"

namespace qm {

/// An open tube of radius 1 and length 6: an annulus, with no extraordinary vertex.
/// \param around  quads around, at least 3
[[nodiscard]] QuadList tubeShape(int around);
[[nodiscard]] TrueSurface tubeSurface();

/// A ring of radius 3 with a tube of radius 1 and no extraordinary vertex.
/// \param around  quads around the tube, at least 3
[[nodiscard]] QuadList torusShape(int around);
[[nodiscard]] TrueSurface torusSurface();

/// A ring whose lines wind around it like the threads of a screw, with a boss on its outside: the boss's
/// eight extraordinary vertices send out separatrices that wind around the ring many times.
/// \param n  quads around the tube, divided by 4
[[nodiscard]] QuadList helixShape(int n);

} // namespace qm

/// \file The distance from a point to a patch.
#pragma once

#include "bspline/evaluate.h"
#include "bspline/surfaces.h"

namespace qm {

/// Least distance that Gauss and Newton's iteration finds from the surface's point at (u, v) on: where it is
/// not exact, it is too large. \param start  the surface there
[[nodiscard]] double distanceToPatch(const Patch& patch, const Point& point, double u, double v,
                                     const SurfacePoint& start);

} // namespace qm

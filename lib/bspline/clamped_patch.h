/// \file Patches with clamped knots, whose outermost control points are their border curves.
#pragma once

#include "bspline/spline_curve.h"
#include "bspline/surfaces.h"

namespace qm {

/// The same bicubic surface over clamped knots: its control net's border is its border. A patch that is
/// clamped stays as it is, and so does the number of control points.
[[nodiscard]] Patch clamped(const Patch& patch);

/// The border curve of a clamped patch along one of its sides, in the side's direction.
[[nodiscard]] SplineCurve borderCurve(const Patch& clampedPatch, int side);

} // namespace qm

/// \file Patches with clamped knots, whose outermost control points are their border curves.
#pragma once

#include "bspline/splines/spline_curve.h"
#include "bspline/splines/surfaces.h"

namespace qm {

/// The same surface over clamped knots: its control net's border is its border. A direction that is clamped
/// stays as it is, as every one of a lower degree than three has to be; the number of control points stays.
[[nodiscard]] Patch clamped(const Patch& patch);

/// The border of a clamped patch along one of its sides, in the side's direction, as a cubic.
[[nodiscard]] SplineCurve borderCurve(const Patch& clampedPatch, int side);

} // namespace qm

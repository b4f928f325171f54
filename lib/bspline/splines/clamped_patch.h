/// \file Patches with clamped knots, whose outermost control points are their border curves.
#pragma once

#include "bspline/splines/spline_curve.h"
#include "bspline/splines/surfaces.h"

#include <vector>

namespace qm {

/// The same surface over clamped knots, so that the outermost control points are those of its border curves.
/// A direction that is clamped already stays as it is; one of a degree below three must be. The number of
/// control points does not change.
[[nodiscard]] Patch clamped(const Patch& patch);

/// The border of a clamped patch along one of its sides, in the side's direction, as a cubic.
[[nodiscard]] SplineCurve borderCurve(const Patch& clampedPatch, int side);

/// The rows of control points, each as a cubic along u over the patch's knots.
[[nodiscard]] std::vector<SplineCurve> rowCurves(const Patch& patch);

/// The same surface with u and v exchanged: rows become columns.
[[nodiscard]] Patch transposed(const Patch& patch);

} // namespace qm

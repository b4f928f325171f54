/// \file The equations that make neighbouring patches meet, and meet smoothly
/// (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_run.h"
#include "bspline/network/stretches.h"

#include <array>
#include <vector>

namespace qm {

/// The strips on both sides of a stretch, in the order of its sides.
using StripPair = std::array<BorderStrip, 2>;

/// Adds the equations (each form is to be 0) by which both sides of a stretch have the same border curve: C0.
/// There are as many as the common refinement of both sides' splines has control points there; those at the
/// ends may repeat what other stretches say.
void addPositionEquations(const Stretch& stretch, const StripPair& strips,
                          std::vector<LinearForm>& equations);

/// Adds the equations for one tangent plane along a run: the derivatives across the border, each into its own
/// patch, sum up to the tangent ratio times the derivative along it: G1 (docs/METHOD.md#peters-2010).
void addTangentEquations(const SmoothRun& run, const StripPair& strips, std::vector<LinearForm>& equations);

} // namespace qm

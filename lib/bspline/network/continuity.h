/// \file The equations that make neighbouring patches meet, and meet smoothly
/// (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/stretches.h"
#include "bspline/network/tangent_ratio.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// A run of smooth edges of a stretch, in mesh edges from the stretch's beginning.
struct SmoothRun {
    std::size_t stretch = 0;
    int begin = 0;
    int end = 0;
    TangentRatio ratio; ///< over 0 to end - begin

    /// The stretch's parameter at a distance from the run's beginning (0) or end (1).
    [[nodiscard]] double parameterAt(std::size_t which, double distance) const {
        return which == 0 ? begin + distance : end - distance;
    }
    /// The distance of a parameter of the stretch from there.
    [[nodiscard]] double distanceFrom(std::size_t which, double parameter) const {
        return which == 0 ? parameter - begin : end - parameter;
    }
};

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

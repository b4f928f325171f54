/// \file The four sides of a patch, turned into the directions of its parameters.
#pragma once

#include "bspline/curve_network.h"
#include "bspline/surfaces.h"

#include <array>

namespace qm {

/// Curves along u (at v = 0 and at the largest v) and along v (at u = 0 and at the largest u), and the
/// partial derivatives across them, S_v and S_u.
struct PatchFrame {
    std::array<SplineCurve, 2> alongU;
    std::array<SplineCurve, 2> alongV;
    std::array<SplineCurve, 2> acrossU; ///< S_v on the curves along u
    std::array<SplineCurve, 2> acrossV; ///< S_u on the curves along v
};

/// \param sides  counter-clockwise from side 0
[[nodiscard]] PatchFrame patchFrame(const std::array<SideCurves, 4>& sides);

/// A clamped patch over the given knots, cubic or, where there are none inside, of a lower degree, with its
/// control points still to be filled in.
[[nodiscard]] Patch emptyPatch(std::vector<double> knotsU, std::vector<double> knotsV);

/// Sets the outermost control points to those of the frame's curves, which the patch's knots must contain.
void setBorder(Patch& patch, const PatchFrame& frame);

} // namespace qm

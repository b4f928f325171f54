/// \file Surfaces that are exactly smooth across all smooth borders, with as few knots as a tolerance allows
/// (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/control.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/fit_target.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

struct SmoothFitOptions {
    double tolerance = 0;  ///< largest distance from the reference, in its unit; positive
    double bending = 1e-4; ///< weight of the thin-plate energy beside the mean squared distance of a quad
    int steps = 4;         ///< of the lattice of points that are fitted, a mesh edge; 1, 2 or 4
    int maxRounds = 30;    ///< systems that are factorised
    int slides = 6;        ///< solutions of each, between which the targets slide
};

/// Patches with common borders, G1 across those that are no creases. Where the tolerance cannot be kept with
/// knot intervals of a quarter of a mesh edge, or bicubics cannot follow the reference, it is missed.
/// \return one patch for every segment, in their order
[[nodiscard]] std::vector<Patch> fitSmooth(const QuadMesh& mesh, const Layout& layout,
                                           const SmoothNetwork& network, const FitTarget& reference,
                                           const SmoothFitOptions& options, const Control& control = {});

} // namespace qm

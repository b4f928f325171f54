/// \file Surfaces that are exactly smooth across all smooth borders, with as few knots as a tolerance allows
/// (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/control.h"
#include "bspline/network/smooth_network.h"
#include "bspline/reference/fit_target.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <functional>
#include <vector>

namespace qm {

struct SmoothFitOptions {
    double tolerance = 0;     ///< largest distance from the reference, in its unit; positive
    double flatness = 0;      ///< references no farther from a plane make plane patches
    int steps = 4;            ///< of the lattice of points that are fitted, a mesh edge; 1, 2 or 4
    double minInterval = 0;   ///< of knots, in tolerances; an eighth of a mesh edge in any case
    int maxRounds = 30;       ///< systems that are factorised
    int roundsForFolds = 30;  ///< from then on places that are near enough may fold
    int slides = 6;           ///< solutions of each, between which the targets slide
    double slack = 0.5;       ///< of the tolerance: so near surfaces may be fairer instead of nearer
    int ringsAround = 2;      ///< of patches that are solved for together with those that change
    double worthAll = 0.6;    ///< of all control points: if there are more to solve for, all are solved for
    bool removesKnots = true; ///< tries to do with fewer, once the tolerance is kept
    int verifications = 5;    ///< how often it is verified at most, if it can be
    int attempts = 5;         ///< while verification finds more than is allowed; see `smooth_fit.cpp`
};

/// The largest distance of every patch from the reference, certain also between the points that a fit looks
/// at, in tolerances: 1 is just allowed.
using Verification = std::function<std::vector<double>(const std::vector<Patch>&)>;

/// Patches with common borders, G1 across those that are no creases. Where the tolerance cannot be kept with
/// knot intervals of an eighth of a mesh edge, or bicubics cannot follow the reference, it is missed.
/// \param verify  may be empty; patches that it finds too far away are fitted more closely
/// \return one patch for every segment, in their order
[[nodiscard]] std::vector<Patch> fitSmooth(const QuadMesh& mesh, const Layout& layout,
                                           const SmoothNetwork& network, const FitTarget& reference,
                                           const SmoothFitOptions& options, const Verification& verify = {},
                                           const Control& control = {});

} // namespace qm

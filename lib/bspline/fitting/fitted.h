/// \file A verified fit, and whether going on from it is worth while.
#pragma once

#include "bspline/fitting/fit_round.h"

#include <cstddef>

namespace qm {

/// A fit that is so many tolerances away will not come within one. It is not verified again and not attempted
/// anew, and its search ends if this many rounds together do not halve the distance. Nor will a fit for which
/// `growth` times the control points of the first round of all attempts do not halve it, or `maxGrowth` times
/// do not reach it: it follows noise.
struct Hopeless {
    static constexpr double distance = 1000;
    static constexpr int rounds = 6;
    static constexpr double growth = 8;
    static constexpr double maxGrowth = 24;
};

/// With what the first attempt began.
struct FirstRound {
    double worst = 0; ///< largest error, in tolerances
    std::size_t controlPoints = 0;
};

struct Fitted {
    FitRound round; ///< with verified distances
    FirstRound first;
    bool followsNoise = false; ///< took very many control points, which did not bring it near

    [[nodiscard]] double farthest() const;
    /// Whether neither mending nor another attempt will bring the fit within the tolerance: it is far away,
    /// or follows noise.
    [[nodiscard]] bool isHopeless() const { return followsNoise || farthest() > Hopeless::distance; }
};

/// Whether a verification finds a distance larger than the previous one by a factor, or more control points
/// without a gain in distance: more rounds would add ever more knots.
[[nodiscard]] bool isAstrayFrom(const Fitted& before, const Fitted& found);

/// Whether a verification finds it far from the tolerance, and hardly nearer than the previous one did.
[[nodiscard]] bool isStuckAt(const Fitted& before, const Fitted& found);

} // namespace qm

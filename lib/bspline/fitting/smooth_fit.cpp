#include "bspline/fitting/smooth_fit.h"

#include "bspline/fitting/fit_attempt.h"
#include "bspline/fitting/system/free_patches.h"

#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// Whether all patches are within the tolerance, but for the uncertainty of a verification.
bool isNear(const Fitted& fitted) {
    constexpr double uncertain = 1.02;
    return fitted.farthest() <= uncertain;
}

/// The patches that miss the tolerance, with so many rings of patches around them.
std::vector<bool> missing(const Fitted& fitted, const FitProblem& problem, int rings) {
    std::vector<bool> misses;
    for (const double distance : fitted.distances)
        misses.push_back(distance > 1);
    return withNeighbours(problem.network.stretches, std::move(misses), rings);
}

} // namespace

std::vector<Patch> fitSmooth(const FitProblem& problem, const SmoothFitOptions& options,
                             const Control& control) {
    if (problem.layout.segments.empty()) return {};
    const std::size_t patches = problem.layout.segments.size();
    Fitted nearest =
        attemptFit(problem, options, std::vector<bool>(patches, false), !options.restarts, control);
    // Stiff patches are fair, but where quads fold or are much narrower than their neighbours they can
    // prevent everything around from following the reference, and so can sliding.
    for (const bool isLast : {false, true}) {
        if (!options.restarts || isNear(nearest) || nearest.isHopeless() || control.stopRequested()) break;
        SmoothFitOptions closer = options;
        closer.slack = 0;
        closer.slides = isLast ? 1 : options.slides / 2;
        const auto isSoft = missing(nearest, problem, isLast ? 3 : 1);
        Fitted fitted = attemptFit(problem, closer, isSoft, isLast, unreported(control));
        if (fitted.farthest() < nearest.farthest()) nearest = std::move(fitted);
    }
    return std::move(nearest.patches);
}

} // namespace qm

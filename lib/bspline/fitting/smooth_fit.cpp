#include "bspline/fitting/smooth_fit.h"

#include "bspline/fitting/fit_attempt.h"
#include "bspline/fitting/system/free_patches.h"

#include <cstddef>
#include <utility>

namespace qm {
namespace {

/// The settings of one attempt. Stiff patches are fair, but where quads fold or are much narrower than their
/// neighbours they can prevent everything around from following the reference, and so can sliding.
struct Attempt {
    std::vector<bool> isSoft; ///< by patch
    SmoothFitOptions options;
};

/// In the first attempt all patches are stiff and may be farther away to be fairer. In the second one they
/// may not, and the patches that miss the tolerance are soft, with their neighbours, and slide less; in later
/// ones all are soft.
Attempt attempt(int number, const Fitted& before, const FitProblem& problem,
                const SmoothFitOptions& options) {
    const std::size_t patches = problem.layout.segments.size();
    if (number == 1) return {std::vector<bool>(patches, false), options};
    Attempt next{std::vector<bool>(patches, true), options};
    next.options.slack = 0;
    next.options.slides >>= number == 2 ? 1 : number - 3;
    if (number > 2) return next;
    for (std::size_t k = 0; k < patches; ++k)
        next.isSoft[k] = before.distances[k] > 1;
    next.isSoft = withNeighbours(problem.network.stretches, std::move(next.isSoft), 1);
    return next;
}

} // namespace

std::vector<Patch> fitSmooth(const FitProblem& problem, const SmoothFitOptions& options,
                             const Control& control) {
    // The relative uncertainty of a verification, for which no new attempt is worth while.
    constexpr double uncertain = 1.02;
    if (problem.layout.segments.empty()) return {};
    Fitted nearest;
    for (int k = 1;; ++k) {
        const auto [isSoft, ofAttempt] = attempt(k, nearest, problem, options);
        Fitted fitted = attemptFit(problem, ofAttempt, isSoft, k == options.attempts,
                                   k == 1 ? control : unreported(control));
        if (k == 1 || fitted.farthest() < nearest.farthest()) nearest = std::move(fitted);
        if (k == options.attempts || nearest.farthest() <= uncertain || nearest.isHopeless() ||
            control.stopRequested())
            return nearest.patches;
    }
}

} // namespace qm

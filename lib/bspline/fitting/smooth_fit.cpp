#include "bspline/fitting/smooth_fit.h"

#include "base/at.h"
#include "base/parallel.h"
#include "bspline/fitting/fit_attempt.h"
#include "bspline/fitting/system/free_patches.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace qm {
namespace {

/// The settings of one attempt. Stiff patches are fair, but where quads fold or are much narrower than their
/// neighbours they can prevent everything around from following the reference, and so can sliding.
struct Attempt {
    std::vector<bool> isSoft; ///< by patch
    SmoothFitOptions options;
};

constexpr double farSlides = 0.35; ///< as a share of a patch's shorter side

/// In the first attempt all patches are stiff and may be farther away to be fairer. In the second one they
/// may not, and the patches that miss the tolerance are soft, with their neighbours, and slide less; in later
/// ones all are soft and may slide farther, as often as in the first, then hardly at all.
Attempt attempt(int number, const Fitted& before, const FitProblem& problem,
                const SmoothFitOptions& options) {
    const std::size_t patches = problem.layout.segments.size();
    if (number == 1) return {std::vector<bool>(patches, false), options};
    Attempt next{std::vector<bool>(patches, true), options};
    next.options.slack = 0;
    if (number > 2) next.options.slideShare = farSlides;
    if (number > 3) next.options.slides = 1;
    if (number > 2) return next;
    next.options.slides /= 2;
    for (std::size_t k = 0; k < patches; ++k)
        next.isSoft[k] = before.distances[k] > 1;
    next.isSoft = withNeighbours(problem.network.stretches, std::move(next.isSoft), 1);
    return next;
}

/// Attempts until one comes near enough.
class Attempts {
public:
    Attempts(const FitProblem& problem, const SmoothFitOptions& options, const Control& control)
        : problem_(problem), options_(options), control_(control) {}

    std::vector<Patch> run() {
        take(made(1, control_));
        if (!isOver() && options_.attempts > 1) take(made(2, unreported(control_)));
        if (!isOver()) runOthers();
        return std::move(nearest_.patches);
    }

private:
    [[nodiscard]] Fitted made(int number, const Control& control) const {
        const auto [isSoft, options] = attempt(number, nearest_, problem_, options_);
        return attemptFit(problem_, options, isSoft, number == options_.attempts, control);
    }

    void take(Fitted fitted) {
        if (nearest_.patches.empty() || fitted.farthest() < nearest_.farthest()) nearest_ = std::move(fitted);
    }

    /// Whether no further attempt is worth while.
    [[nodiscard]] bool isOver() const { return isSettled() || control_.stopRequested(); }
    [[nodiscard]] bool isSettled() const { return isNear(nearest_) || nearest_.isHopeless(); }

    /// But for the uncertainty of a verification.
    [[nodiscard]] static bool isNear(const Fitted& fitted) {
        constexpr double uncertain = 1.02;
        return fitted.farthest() <= uncertain;
    }

    /// Those after the second do not depend on one another, so they run side by side. They are taken in their
    /// order up to the first that comes near: what the others found then is the same as if they had not run.
    void runOthers() {
        constexpr int first = 3;
        std::vector<std::optional<Fitted>> found(at(std::max(0, options_.attempts - first + 1)));
        std::vector<std::atomic<bool>> cameNear(found.size());
        parallelFor(found.size(), control_.jobs, [&](std::size_t k) {
            Control control = unreported(control_);
            const std::span before(cameNear.data(), k);
            control.stopRequested = [this, before] {
                return std::ranges::any_of(before, [](const auto& isNear) { return isNear.load(); }) ||
                       control_.stopRequested();
            };
            control.jobs = std::max(1U, control_.jobs / static_cast<unsigned>(found.size()));
            if (control.stopRequested()) return;
            found[k] = made(first + static_cast<int>(k), control);
            cameNear[k] = isNear(*found[k]);
        });
        for (std::optional<Fitted>& fitted : found)
            if (fitted && !isSettled()) take(std::move(*fitted));
    }

    const FitProblem& problem_;
    const SmoothFitOptions& options_;
    const Control& control_;
    Fitted nearest_;
};

} // namespace

std::vector<Patch> fitSmooth(const FitProblem& problem, const SmoothFitOptions& options,
                             const Control& control) {
    if (problem.layout.segments.empty()) return {};
    return Attempts(problem, options, control).run();
}

} // namespace qm

#include "bspline/fitting/fit_attempt.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/fitting/best_rounds.h"
#include "bspline/fitting/first_solution.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/fitting/verified_flattening.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// How often a search tries to do with fewer knots.
constexpr int maxRemovals = 6;
/// Once flattening has broken the tolerance so often, the planes near what misses it are given up, since
/// knots have not helped, and after `max` times rounds are no longer flattened.
struct Flattenings {
    static constexpr int patience = 3;
    static constexpr int max = 8;
};
/// Number of rounds after a removal within which the tolerance must be kept again.
constexpr int maxRepairs = 4;
/// Weights alone are changed as long as each round leaves at most this share of what is missed.
constexpr double worthwhileGain = 0.9;
/// Removals are repeated as long as each leaves at most this share of the control points.
constexpr double worthwhile = 0.985;

/// After so many rounds, folds that are near enough are accepted.
constexpr int roundsForFolds = 30;

/// What a search remembers of its rounds.
struct Rounds {
    int idle = 0;                    ///< how many have passed since one was kept
    int halved = 0;                  ///< the last one in which the largest distance had become half as large
    double distance = infinity;      ///< the largest distance in that round
    double excess = infinity;        ///< of the last round, see `FitErrors::excess`
    int removals = 0;                ///< how often knots were removed
    int repairs = 0;                 ///< rounds since the last removal
    double controlPoints = infinity; ///< their number before the last removal
};

std::vector<bool> softPatches(const FitProblem& problem, const std::optional<Restart>& restart) {
    return restart ? restart->isSoft : std::vector<bool>(problem.layout.segments.size());
}

class FitAttempt {
public:
    FitAttempt(const FitProblem& problem, const SmoothFitOptions& options,
               const std::optional<Restart>& restart, unsigned jobs)
        : problem_(problem), options_(options),
          planes_(flatPatches(problem.layout, problem.reference.grids, problem.network, options.flatness)),
          state_(problem, options, softPatches(problem, restart), jobs), restart_(restart) {}

    Fitted run(bool isLast, const Control& control) {
        const int slides = 2 * options_.slides; // more while there are few knots, or patches begin anew
        if (restart_) {
            first_ = restart_->from.first;
            state_.beginFrom(restart_->from.round, restart_->isSoft, slides);
        } else {
            solveFirst(state_, slides, control.stopRequested);
        }
        search(options_.maxRounds, options_.removesKnots ? Saving::tried : Saving::none, control);
        Fitted nearest;
        for (int k = 1;; ++k) {
            FitRound& best = best_.choose(problem_.verify);
            if (hasPlanes()) flattenWhereKept(problem_.verify, options_.slides, planes_, state_, best);
            Fitted found{best, first_, followsNoise()};
            const bool ends =
                k > 1 && (isStuckAt(nearest, found) || (!isLast && isAstrayFrom(nearest, found)));
            if (k == 1 || found.farthest() < nearest.farthest()) nearest = std::move(found);
            if (ends || nearest.isHopeless() || k == options_.verifications || control.stopRequested())
                return nearest;
            state_.restore(best);
            if (!state_.tighten(best)) return nearest;
            best_ = {};
            search(options_.roundsOfMending, Saving::none, unreported(control));
        }
    }

private:
    /// Whether a search that keeps the tolerance tries to do with fewer knots.
    enum class Saving { none, tried };

    /// Alternates between placing knots and fitting until the tolerance is kept and no knots can be saved.
    void search(int maxRounds, Saving saving, const Control& control) {
        Rounds past;
        for (int round = 0; round < maxRounds; ++round) {
            control.progress(static_cast<double>(round) / maxRounds);
            if (round > 0) state_.solveChanged(options_.slides);
            const bool hasBroken = flattenIfKept();
            past.idle = best_.take(state_) ? 0 : past.idle + (hasBroken ? 0 : 1);
            if (past.idle == options_.maxIdle || control.stopRequested() || isInVain(round, past)) break;
            if (++rounds_ > roundsForFolds) state_.giveUpFolds();
            if (state_.errors().worst() <= 1) {
                const bool leavesRepairs = round + maxRepairs <= maxRounds;
                if (saving == Saving::none || !leavesRepairs || !removeKnots(past)) break;
            } else if (!best_.keepsTolerance()) {
                comeNearer(past);
            } else if (!repair(past)) {
                break;
            }
        }
    }

    /// Whether the search will not come within the tolerance, or follows noise.
    bool isInVain(int round, Rounds& past) {
        if (2 * state_.errors().worst() <= past.distance) {
            past.distance = state_.errors().worst();
            past.halved = round;
        }
        if (state_.errors().worst() > Hopeless::distance && round - past.halved >= Hopeless::rounds)
            return true;
        if (rounds_ == 0 && !restart_) first_ = {state_.errors().worst(), state_.score().controlPoints};
        return followsNoise();
    }

    /// \return false if that is no longer worth while, or no knot can go
    bool removeKnots(Rounds& past) {
        const auto count = static_cast<double>(best_.controlPoints());
        if (past.removals++ == maxRemovals || count > worthwhile * past.controlPoints) return false;
        past.controlPoints = count;
        past.repairs = 0;
        return state_.removeKnots();
    }

    /// Puts back knots whose removal breaks the tolerance, more from round to round.
    /// \return false if that has not helped
    bool repair(Rounds& past) {
        using enum FitState::Where;
        constexpr std::array<FitState::Where, maxRepairs> steps{inCells, inPatches, aroundPatches,
                                                                aroundPatches};
        while (past.repairs < maxRepairs) {
            const bool isWeighed = state_.weighWhatIsMissed();
            if (state_.putBackKnots(steps[at(past.repairs++)]) || isWeighed) return true;
        }
        return false;
    }

    /// Gives weight to what misses and divides it, or does what helps where neither does.
    void comeNearer(Rounds& past) {
        const bool isWeighed = state_.weighWhatIsMissed();
        const bool isRefined = state_.refine();
        // Without more knots to insert, weights may still help.
        const bool gains =
            state_.errors().excess() < worthwhileGain * std::exchange(past.excess, state_.errors().excess());
        if (!isRefined && !(isWeighed && gains) && !tryHarder()) state_.giveUp();
    }

    /// Whether very many control points have not brought it much nearer than it was in the first round of all
    /// attempts, or still more not within the tolerance.
    [[nodiscard]] bool followsNoise() const {
        const double growth =
            static_cast<double>(state_.score().controlPoints) / static_cast<double>(first_.controlPoints);
        const double worst = state_.errors().worst();
        return !best_.keepsTolerance() && worst > 1 &&
               growth > (2 * worst > first_.worst ? Hopeless::growth : Hopeless::maxGrowth);
    }

    /// Does what helps where neither knots nor weights do. Beside folds short intervals would only make
    /// spikes.
    /// \return false if all has been done
    bool tryHarder() {
        if (state_.errors().isAnyFolded()) return state_.stopSliding() || state_.allow(MinInterval::eighth);
        return state_.allow(MinInterval::eighth) || state_.stopSliding() ||
               state_.allow(MinInterval::thirtySecond);
    }

    /// Once the tolerance is kept, it is to be kept with plane patches in their planes: what these push away
    /// is refined as well. Some planes cannot be reached within the tolerance.
    /// \return whether only the planes break the tolerance, and it has not been kept with planes before
    bool flattenIfKept() {
        if (!hasPlanes() || flattenings_ == Flattenings::max || state_.errors().worst() > 1) return false;
        if (!best_.keepsTolerance()) best_.takeUnflattened(state_);
        state_.flatten(planes_, options_.slides);
        if (state_.errors().worst() <= 1 || best_.keepsTolerance()) return false;
        if (++flattenings_ >= Flattenings::patience)
            dropPlanes(problem_.network.stretches, state_.errors().areMissed(), planes_);
        return true;
    }

    [[nodiscard]] bool hasPlanes() const {
        return std::ranges::any_of(planes_, [](const auto& plane) { return plane.has_value(); });
    }

    const FitProblem& problem_;
    const SmoothFitOptions& options_;
    std::vector<std::optional<FlatPatch>> planes_; ///< by patch; those out of reach are dropped
    FitState state_;
    const std::optional<Restart>& restart_;
    FirstRound first_;
    int flattenings_ = 0; ///< that broke the tolerance
    int rounds_ = 0;      ///< in all searches together
    BestRounds best_;
};

} // namespace

Fitted attemptFit(const FitProblem& problem, const SmoothFitOptions& options,
                  const std::optional<Restart>& restart, bool isLast, const Control& control) {
    return FitAttempt(problem, options, restart, control.jobs).run(isLast, control);
}

} // namespace qm

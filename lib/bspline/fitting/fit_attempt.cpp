#include "bspline/fitting/fit_attempt.h"

#include "base/infinity.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/fitting/verified_flattening.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// How often a search tries to do with fewer knots.
constexpr int maxRemovals = 6;
/// Rounds are no longer flattened after this has broken the tolerance so often.
constexpr int maxFlattenings = 8;
/// Number of rounds after a removal within which the tolerance must be kept again.
constexpr int maxRepairs = 4;
/// A search ends after so many rounds without a better result.
constexpr int maxIdle = 12;
/// Weights alone are changed as long as each round leaves at most this share of what is missed.
constexpr double worthwhileGain = 0.9;
/// Removals are repeated as long as each leaves at most this share of the control points.
constexpr double worthwhile = 0.985;

/// After so many rounds, folds that are near enough are accepted.
constexpr int roundsForFolds = 30;
/// Number of rounds for mending what a verification has found.
constexpr int roundsOfMending = 8;

/// If a verification finds a distance or a number of control points larger than the previous one by these
/// factors, the attempt ends, unless it is the last one: more rounds would add ever more knots.
struct Astray {
    static constexpr double distance = 1.2;
    static constexpr double points = 1.5;
};

/// A fit that is so many tolerances away will not come within one. It is not verified again and not attempted
/// anew, and its search ends if this many rounds together do not halve the distance. Nor will a fit for which
/// so many times the control points of its first round do not halve it: it follows noise.
struct Hopeless {
    static constexpr double distance = 1000;
    static constexpr int rounds = 6;
    static constexpr double growth = 8;
};

/// When a search has last halved the distance.
class Halving {
public:
    /// \return in how many rounds it has not been halved
    int idleRounds(int round, double distance) {
        if (2 * distance <= distance_) {
            distance_ = distance;
            round_ = round;
        }
        return round - round_;
    }

private:
    int round_ = 0;
    double distance_ = infinity;
};

/// The removals of knots of a search.
class Removals {
public:
    /// \param controlPoints  of the best round so far
    [[nodiscard]] bool isWorthwhile(std::size_t controlPoints) const {
        return count_ < maxRemovals && static_cast<double>(controlPoints) <= worthwhile * before_;
    }
    void note(int round, std::size_t controlPoints) {
        ++count_;
        round_ = round;
        before_ = static_cast<double>(controlPoints);
    }
    /// The round of the last one; 0 if there was none.
    [[nodiscard]] int lastRound() const { return round_; }

private:
    int count_ = 0;
    int round_ = 0;
    double before_ = infinity; ///< control points
};

bool isAstrayFrom(const Fitted& before, const Fitted& found) {
    const auto points = [](const Fitted& fitted) {
        return static_cast<double>(controlPointCount(fitted.patches));
    };
    return found.farthest() > Astray::distance * before.farthest() ||
           points(found) > Astray::points * points(before);
}

class FitAttempt {
public:
    FitAttempt(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
               const FitTarget& reference, const SmoothFitOptions& options, const std::vector<bool>& isSoft,
               const Verification& verify, unsigned jobs)
        : layout_(layout), options_(options), verify_(verify), jobs_(jobs),
          planes_(flatPatches(layout, reference.grids, network, options.flatness)),
          state_(mesh, layout, network, reference, options, isSoft, jobs) {}

    Fitted run(bool isLast, const Control& control) {
        state_.solveAll(2 * options_.slides); // more slides while there are few knots
        search(options_.maxRounds, options_.removesKnots ? Saving::tried : Saving::none, control);
        Fitted nearest;
        for (int k = 1;; ++k) {
            chooseBest();
            if (hasPlanes()) flattenWhereKept(layout_, planes_, verify_, best_, jobs_);
            Fitted found{best_.patches, best_.distances, followsNoise()};
            const bool isAstray = !isLast && k > 1 && isAstrayFrom(nearest, found);
            if (k == 1 || found.farthest() < nearest.farthest()) nearest = std::move(found);
            if (isAstray || nearest.isHopeless() || k == options_.verifications || control.stopRequested())
                return nearest;
            state_.restore(best_);
            if (!state_.tighten(best_)) return nearest;
            best_ = {};
            nearest_ = {};
            search(roundsOfMending, Saving::none, unreported(control));
        }
    }

private:
    /// Whether a search that keeps the tolerance tries to do with fewer knots.
    enum class Saving { none, tried };

    /// Alternates between placing knots and fitting until the tolerance is kept and no knots can be saved.
    void search(int maxRounds, Saving saving, const Control& control) {
        Halving halving;
        Removals removals;
        int idle = 0;
        double excessBefore = infinity;
        for (int round = 0; round < maxRounds; ++round) {
            control.progress(static_cast<double>(round) / maxRounds);
            if (round > 0) state_.solveChanged(options_.slides);
            flattenIfKept();
            idle = keepIfBest() ? 0 : idle + 1;
            if (idle == maxIdle || control.stopRequested() || isInVain(halving, round)) break;
            if (++rounds_ > roundsForFolds) state_.giveUpFolds();
            if (state_.worst() <= 1) {
                const bool hasRoundsForRepairs = round + maxRepairs <= maxRounds;
                const std::size_t count = best_.score.controlPoints;
                if (saving == Saving::none || !hasRoundsForRepairs || !removals.isWorthwhile(count)) break;
                removals.note(round, count);
                if (state_.removeKnots() == 0) break;
            } else {
                if (best_.score.keeps && idle > 0 && round - removals.lastRound() > maxRepairs) break;
                if (!approach(excessBefore) && !tryHarder()) state_.giveUp();
            }
        }
    }

    /// Whether the search will not come within the tolerance, or follows noise.
    bool isInVain(Halving& halving, int round) {
        const int idleRounds = halving.idleRounds(round, state_.worst());
        if (state_.worst() > Hopeless::distance && idleRounds >= Hopeless::rounds) return true;
        if (rounds_ == 0) {
            firstWorst_ = state_.worst();
            firstPoints_ = state_.score().controlPoints;
        }
        return followsNoise();
    }

    /// Increases weights, and inserts knots.
    /// \param excessBefore  that of the round before; becomes that of this one
    /// \return whether the next round may be nearer: without more knots to insert, weights may still help
    bool approach(double& excessBefore) {
        const bool isWeighed = state_.weighWhatIsMissed();
        const bool isRefined = state_.refine();
        const bool gains = state_.excess() < worthwhileGain * excessBefore;
        excessBefore = state_.excess();
        return isRefined || (isWeighed && gains);
    }

    /// Whether very many control points have not brought it much nearer than it was in its first round.
    [[nodiscard]] bool followsNoise() const {
        const auto points = static_cast<double>(state_.score().controlPoints);
        return !best_.score.keeps && state_.worst() > 1 && 2 * state_.worst() > firstWorst_ &&
               points > Hopeless::growth * static_cast<double>(firstPoints_);
    }

    /// Does what helps where neither knots nor weights do. Beside folds short intervals would only make
    /// spikes.
    /// \return false if all has been done
    bool tryHarder() {
        if (state_.isFolded()) return state_.stopSliding() || state_.allow(MinInterval::eighth);
        return state_.allow(MinInterval::eighth) || state_.stopSliding() ||
               state_.allow(MinInterval::thirtySecond);
    }

    /// Once the tolerance is kept, it is to be kept with plane patches in their planes: what these push away
    /// is refined as well. Some planes cannot be reached within the tolerance.
    void flattenIfKept() {
        if (!hasPlanes() || flattenings_ == maxFlattenings || state_.worst() > 1) return;
        state_.flatten(planes_);
        if (state_.worst() > 1) ++flattenings_;
    }

    [[nodiscard]] bool hasPlanes() const {
        return std::ranges::any_of(planes_, [](const auto& plane) { return plane.has_value(); });
    }

    /// The largest distance of a round, in tolerances.
    double verified(FitRound& round) const {
        if (round.distances.empty()) round.distances = verify_(round.patches);
        return std::ranges::max(round.distances);
    }

    /// \return whether the round is the best so far by either criterion
    bool keepIfBest() {
        const RoundScore score = state_.score();
        const bool isBest = best_.patches.empty() || isBetter(score, best_.score, Criterion::tolerance);
        const bool isNearest = nearest_.patches.empty() || isBetter(score, nearest_.score, Criterion::errors);
        if (!isBest && !isNearest) return false;
        const FitRound round = state_.round();
        if (isBest) best_ = round;
        if (isNearest) nearest_ = round;
        return true;
    }

    /// Prefers the nearest round to the best if a verification finds it nearer, which the lattices cannot
    /// tell.
    void chooseBest() {
        const double ofBest = verified(best_);
        if (ofBest > 1 && !(nearest_.score == best_.score) && verified(nearest_) < ofBest)
            best_ = std::move(nearest_);
    }

    const Layout& layout_;
    const SmoothFitOptions& options_;
    const Verification& verify_;
    unsigned jobs_;
    std::vector<std::optional<FlatPatch>> planes_;
    FitState state_;
    int flattenings_ = 0;   ///< that broke the tolerance
    int rounds_ = 0;        ///< in all searches together
    double firstWorst_ = 0; ///< of the first round of all
    std::size_t firstPoints_ = 0;
    FitRound best_;
    FitRound nearest_; ///< the best if errors that are given up count like all others
};

} // namespace

double Fitted::farthest() const {
    return std::ranges::max(distances);
}

bool Fitted::isHopeless() const {
    return followsNoise || farthest() > Hopeless::distance;
}

Fitted attemptFit(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                  const FitTarget& reference, const SmoothFitOptions& options,
                  const std::vector<bool>& isSoft, bool isLast, const Verification& verify,
                  const Control& control) {
    return FitAttempt(mesh, layout, network, reference, options, isSoft, verify, control.jobs)
        .run(isLast, control);
}

} // namespace qm

#include "bspline/fitting/smooth_fit.h"

#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/fit_state.h"
#include "bspline/fitting/flattening.h"
#include "bspline/fitting/free_unknowns.h"
#include "bspline/fitting/plane_patches.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace qm {
namespace {

constexpr int maxRemovals = 6;
/// Rounds that it may take after a removal to keep the tolerance again.
constexpr int maxRepairs = 4;
/// Rounds without a better result, after which none is expected.
constexpr int maxIdle = 12;
/// Weights alone go on while each round leaves at most this share of what is missed.
constexpr double worthwhileGain = 0.9;
/// Removals go on while each leaves at most this share of the control points.
constexpr double worthwhile = 0.985;

/// Rounds that it may take to mend what a verification has found.
constexpr int roundsOfMending = 8;

/// A verification that finds so much more than one before, or with so many more control points, is the
/// last, if all can begin anew: what follows takes ever more knots.
struct Astray {
    static constexpr double distance = 1.2;
    static constexpr double points = 1.5;
};

/// What is so many tolerances away will not come within one: it is not verified again nor begun anew, and
/// the search for it ends where many rounds together do not halve the distance.
struct Hopeless {
    static constexpr double distance = 1000;
    static constexpr int rounds = 6;
};

struct Fitted {
    std::vector<Patch> patches;
    std::vector<double> distances; ///< by patch, in tolerances, if they were verified

    /// 0 without patches.
    [[nodiscard]] double farthest() const { return distances.empty() ? 0 : std::ranges::max(distances); }
    [[nodiscard]] bool isHopeless() const { return farthest() > Hopeless::distance; }
};

bool isAstrayFrom(const Fitted& before, const Fitted& found) {
    const auto points = [](const Fitted& fitted) {
        return static_cast<double>(controlPointCount(fitted.patches));
    };
    return found.farthest() > Astray::distance * before.farthest() ||
           points(found) > Astray::points * points(before);
}

class SmoothFit {
public:
    SmoothFit(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
              const FitTarget& reference, const SmoothFitOptions& options, const std::vector<bool>& isSoft,
              unsigned jobs)
        : layout_(layout), options_(options), jobs_(jobs),
          planes_(planesOf(reference.grids, network, options.flatness)),
          state_(mesh, layout, network, reference, options, isSoft, jobs) {}

    Fitted run(const Verification& verify, bool mayBeginAnew, const Control& control) {
        state_.solve(2 * options_.slides, true); // more while there are few knots
        search(options_.maxRounds, options_.removesKnots, control);
        chooseBest(verify);
        flattenBest(verify);
        if (!verify) return {std::move(best_.patches), {}};
        Fitted nearest;
        for (int k = 1;; ++k) {
            Fitted found{best_.patches, verified(best_, verify)};
            const bool isAstray = mayBeginAnew && k > 1 && isAstrayFrom(nearest, found);
            if (k == 1 || found.farthest() < nearest.farthest()) nearest = std::move(found);
            if (isAstray || nearest.isHopeless() || k == options_.verifications) return nearest;
            state_.restore(best_);
            if (!state_.tighten(best_)) return nearest;
            best_ = {};
            nearest_ = {};
            search(roundsOfMending, false, {});
            chooseBest(verify);
            flattenBest(verify);
        }
    }

private:
    /// Rounds of placing knots and fitting, until the tolerance is kept and nothing can be saved.
    /// \param saves  goes on to do with fewer knots
    void search(int maxRounds, bool saves, const Control& control) {
        int removals = 0;
        int lastKept = 0;
        int idle = 0;
        int halved = 0;
        double halvedWorst = std::numeric_limits<double>::infinity();
        double excessBefore = std::numeric_limits<double>::infinity();
        double countBefore = std::numeric_limits<double>::infinity();
        for (int round = 0; round < maxRounds; ++round) {
            control.progress(static_cast<double>(round) / maxRounds);
            if (round > 0) state_.solve(options_.slides, false);
            idle = keepIfBest() ? 0 : idle + 1;
            if (idle == maxIdle) break;
            if (2 * state_.worst() <= halvedWorst) {
                halvedWorst = state_.worst();
                halved = round;
            }
            if (state_.worst() > Hopeless::distance && round - halved >= Hopeless::rounds) break;
            if (++rounds_ > options_.roundsForFolds) state_.giveUpFolds();
            if (state_.worst() <= 1) {
                const auto count = static_cast<double>(controlPointCount(best_.patches));
                if (!saves || round + maxRepairs > maxRounds) break; // too late
                if (removals++ == maxRemovals || count > worthwhile * countBefore) break;
                countBefore = count;
                lastKept = round;
                if (state_.removeKnots() == 0) break;
                continue;
            }
            if (best_.score.keeps && idle > 0 && round - lastKept > maxRepairs) break;
            const bool weighed = state_.weighWhatIsMissed();
            const bool refined = state_.refine();
            // What has no more knots to get may still gain by weights, while it does.
            const bool gains = state_.excess() < worthwhileGain * excessBefore;
            excessBefore = state_.excess();
            if (refined || (weighed && gains)) continue;
            if (!state_.stopSliding() && !state_.allowShorterIntervals()) state_.giveUp();
        }
    }

    static const std::vector<double>& verified(FitRound& round, const Verification& verify) {
        if (round.distances.empty()) round.distances = verify(round.patches);
        return round.distances;
    }

    /// Planes that would spoil the tolerance are left out.
    void flattenBest(const Verification& verify) {
        if (std::ranges::none_of(planes_, [](const auto& plane) { return plane.has_value(); })) return;
        constexpr int attempts = 5;
        constexpr double worse = 1.01;
        const KnotPlan& plan = *best_.plan;
        const std::vector<PatchSpace> spaces = plan.spaces();
        auto planes = planes_;
        for (int k = 0; k < attempts; ++k) {
            std::vector<Patch> flat = best_.patches;
            flatten(layout_, plan.network(), spaces, planes, flat, jobs_);
            std::vector<double> after = verify ? verify(flat) : std::vector<double>();
            const auto isSpoiled = [&](std::size_t patch) {
                return after[patch] > std::max(1.0, worse * verified(best_, verify)[patch]);
            };
            bool spoils = false;
            for (std::size_t patch = 0; patch < after.size(); ++patch)
                spoils = spoils || isSpoiled(patch);
            if (!spoils) {
                best_.patches = std::move(flat);
                best_.distances = std::move(after);
                return;
            }
            for (const Stretch& stretch : plan.network().stretches)
                for (const std::size_t side : {0U, 1U})
                    if (isSpoiled(stretch.sides[side].patch)) {
                        planes[stretch.sides[0].patch].reset();
                        planes[stretch.sides[1].patch].reset();
                    }
        }
    }

    /// \return whether the round was the best so far, by either rule
    bool keepIfBest() {
        const RoundScore score = state_.score();
        const bool isBest = best_.patches.empty() || isBetter(score, best_.score, true);
        const bool isNearest = nearest_.patches.empty() || isBetter(score, nearest_.score, false);
        if (!isBest && !isNearest) return false;
        const FitRound round = state_.round(options_.verifications > 0);
        if (isBest) best_ = round;
        if (isNearest) nearest_ = round;
        return true;
    }

    /// Takes the nearest instead where that is in truth nearer, which the lattices do not tell.
    void chooseBest(const Verification& verify) {
        if (!verify || nearest_.patches.empty() || nearest_.score == best_.score) return;
        const double ofBest = std::ranges::max(verified(best_, verify));
        if (ofBest > 1 && std::ranges::max(verified(nearest_, verify)) < ofBest) best_ = std::move(nearest_);
    }

    const Layout& layout_;
    const SmoothFitOptions& options_;
    unsigned jobs_;
    std::vector<std::optional<Plane>> planes_;
    FitState state_;
    int rounds_ = 0; ///< of all searches
    FitRound best_;
    FitRound nearest_; ///< the same, if what is given up counts as all else does
};

/// Stiff patches are fair, but where quads fold or are much narrower than their neighbours they may keep all
/// around from following the reference; and sliding may lead astray.
struct Attempt {
    std::vector<bool> isSoft; ///< by patch
    SmoothFitOptions options;
};

/// At first all patches are stiff, and may be fairer than near. Then nothing is as good as to be near, and
/// those are soft, and slide less, that miss the tolerance, with those around them; then all are.
Attempt attempt(int number, const Fitted& before, const SmoothNetwork& network, std::size_t patches,
                const SmoothFitOptions& options) {
    if (number == 1) return {std::vector<bool>(patches, false), options};
    Attempt next{std::vector<bool>(patches, true), options};
    next.options.slack = 0;
    next.options.slides >>= number == 2 ? 1 : number - 3;
    if (number > 2) return next;
    for (std::size_t k = 0; k < patches; ++k)
        next.isSoft[k] = before.distances[k] > 1;
    next.isSoft = withNeighbours(network, std::move(next.isSoft), 1);
    return next;
}

} // namespace

std::vector<Patch> fitSmooth(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                             const FitTarget& reference, const SmoothFitOptions& options,
                             const Verification& verify, const Control& control) {
    // What is verified may be off by this, and is not worth a new beginning.
    constexpr double uncertain = 1.02;
    const std::size_t patches = layout.segments.size();
    if (patches == 0) return {};
    Fitted nearest;
    for (int k = 1;; ++k) {
        const auto [isSoft, ofAttempt] = attempt(k, nearest, network, patches, options);
        Fitted fitted = SmoothFit(mesh, layout, network, reference, ofAttempt, isSoft, control.jobs)
                            .run(verify, k < options.attempts, k == 1 ? control : Control());
        if (k == 1 || fitted.farthest() < nearest.farthest()) nearest = std::move(fitted);
        if (k == options.attempts || !verify || nearest.farthest() <= uncertain || nearest.isHopeless())
            return nearest.patches;
    }
}

} // namespace qm

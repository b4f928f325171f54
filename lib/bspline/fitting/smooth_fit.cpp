#include "bspline/fitting/smooth_fit.h"

#include "base/parallel.h"
#include "bspline/fitting/continuity_equations.h"
#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/flattening.h"
#include "bspline/fitting/free_unknowns.h"
#include "bspline/fitting/given_up_cells.h"
#include "bspline/fitting/initial_knots.h"
#include "bspline/fitting/knot_insertion.h"
#include "bspline/fitting/knot_removal.h"
#include "bspline/fitting/lattice_cells.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/fitting/plane_patches.h"
#include "bspline/fitting/smooth_system.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// A spline is farther from a function than single cubics over its intervals, by this share.
constexpr double cubicsShare = 0.2;

/// Errors that removals may come to; what is near 1 comes back.
constexpr double removalLimit = 0.9;

constexpr int maxRemovals = 6;
/// Rounds that it may take after a removal to keep the tolerance again.
constexpr int maxRepairs = 4;
/// Rounds without a better result, after which none is expected.
constexpr int maxIdle = 12;
/// Weights alone go on while each round leaves at most this share of what is missed.
constexpr double worthwhileGain = 0.9;
/// Removals go on while each leaves at most this share of the control points.
constexpr double worthwhile = 0.985;

/// A weight may grow by `growth` a round, up to `max`.
struct Emphasis {
    static constexpr double growth = 3;
    static constexpr double max = 100;
};

/// How often a fit is verified, and the rounds that it may take to mend what was found.
constexpr int maxVerifications = 5;
constexpr int roundsOfMending = 8;

/// What a round changes is solved for together with so many patches around.
constexpr int ringsAround = 2;
/// With small patches there are more of them, until there are so many control points.
constexpr double minPoints = 1000;
/// Of all control points: if there are more to solve for, the rest is solved for as well.
constexpr double worthAll = 0.6;

class SmoothFit {
public:
    SmoothFit(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
              const FitTarget& reference, const SmoothFitOptions& options, unsigned jobs)
        : layout_(layout), options_(options), jobs_(jobs), map_(mesh, layout, network),
          plan_(layout, network), planes_(planesOf(reference.grids, network, options.flatness)),
          sources_(latticeSources(mesh, layout, network, reference.grids, reference.weights)),
          lattices_(sources_.size()), errors_(sources_.size()), givenUp_(sources_.size()),
          reweighed_(sources_.size()), missed_(sources_.size()), scale_(sources_.size(), 1) {
        parallelFor(sources_.size(), jobs_,
                    [&](std::size_t k) { lattices_[k] = makeLattice(sources_[k], parametersOf(k, {})); });
        insertInitialKnots(layout, lattices_, map_, cubicsShare * options.tolerance, plan_);
        plan_.endAtFirstKnots();
    }

    std::vector<Patch> run(const Verification& verify, const Control& control) {
        solve(2 * options_.slides, true); // more while there are few knots
        search(options_.maxRounds, true, control);
        chooseBest(verify);
        flattenBest(verify);
        if (!verify) return std::move(best_.patches);
        std::vector<Patch> nearest;
        double distance = std::numeric_limits<double>::infinity();
        for (int k = 1;; ++k) {
            const double found = std::ranges::max(verified(best_, verify));
            if (found < distance) nearest = best_.patches;
            distance = std::min(distance, found);
            if (k == maxVerifications) return nearest;
            const FitRound before = takeUpBest();
            if (!tighten(before.distances, before.missed)) return nearest;
            assess(std::vector<bool>(sources_.size(), true));
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
        double excessBefore = std::numeric_limits<double>::infinity();
        double countBefore = std::numeric_limits<double>::infinity();
        for (int round = 0; round < maxRounds; ++round) {
            control.progress(static_cast<double>(round) / maxRounds);
            if (round > 0) solve(options_.slides, false);
            idle = keepIfBest() ? 0 : idle + 1;
            if (idle == maxIdle) break;
            if (worst_ <= 1) {
                const auto count = static_cast<double>(controlPointCount(best_.patches));
                if (!saves || removals++ == maxRemovals || count > worthwhile * countBefore) break;
                countBefore = count;
                lastKept = round;
                if (removeKnots(lattices_, patches_, errors_, options_.tolerance, removalLimit, plan_) == 0)
                    break;
                continue;
            }
            if (best_.score.keeps && idle > 0 && round - lastKept > maxRepairs) break;
            const bool weighed = weighWhatIsMissed();
            const bool refined = refine(layout_, lattices_, map_, spaces_, errors_, plan_);
            // What has no more knots to get may still gain by weights, while it does.
            const bool gains = excess_ < worthwhileGain * excessBefore;
            excessBefore = excess_;
            if (!refined && !(weighed && gains) && !stopSliding() && !plan_.allowShorter()) giveUp();
        }
    }

    /// Goes back to the best round, which is no longer the one to beat.
    FitRound takeUpBest() {
        plan_ = *best_.plan;
        spaces_ = plan_.spaces();
        lattices_ = best_.lattices;
        patches_ = best_.patches;
        solvedRuns_ = plan_.network().runs;
        assess(std::vector<bool>(sources_.size(), true));
        nearest_ = {};
        return std::exchange(best_, {});
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
            flatten(layout_, plan.network(), spaces, planes, flat);
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
            for (const Stretch& stretch : plan_.network().stretches)
                for (const std::size_t side : {0, 1})
                    if (isSpoiled(stretch.sides[side].patch)) {
                        planes[stretch.sides[0].patch].reset();
                        planes[stretch.sides[1].patch].reset();
                    }
        }
    }

    /// Errors of patches that are farther away than their lattices tell count so much more from now on that
    /// the largest is what was found.
    /// \return false if there are none
    bool tighten(const std::vector<double>& found, const std::vector<double>& missed) {
        constexpr double reserve = 1.03;
        constexpr double agreement = 1.02;
        bool changed = false;
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double told = errors_[k].max();
            if (found[k] <= 1 || found[k] <= agreement * (1 + missed[k]) || !(told > 0)) continue;
            scale_[k] *= reserve * found[k] / std::min(told, 1.0);
            changed = true;
        }
        return changed;
    }

    [[nodiscard]] std::array<std::vector<double>, 2>
    parametersOf(std::size_t patch, const std::array<std::vector<double>, 2>& knots) const {
        const auto& size = layout_.segments[patch].size;
        return {latticeParameters(size[0], options_.steps, knots[0]),
                latticeParameters(size[1], options_.steps, knots[1])};
    }

    /// What has changed since the last solution, and what still errs.
    [[nodiscard]] std::vector<bool> changedPatches(const std::vector<PatchSpace>& before) const {
        std::vector<bool> changed = reweighed_;
        for (std::size_t k = 0; k < sources_.size(); ++k)
            if (spaces_[k].knots != before[k].knots || errors_[k].max() > 1) changed[k] = true;
        for (std::size_t k = 0; k < solvedRuns_.size(); ++k)
            if (const SmoothRun& run = plan_.network().runs[k]; run.ratio != solvedRuns_[k].ratio)
                for (const StretchSide& side : plan_.network().stretches[run.stretch].sides)
                    changed[side.patch] = true;
        return changed;
    }

    /// Solves for what has changed, with what lies around it, or for all.
    void solve(int drafts, bool forAll) {
        const std::vector<PatchSpace> spacesBefore = std::exchange(spaces_, plan_.spaces());
        const std::vector<bool> all(sources_.size(), true);
        std::vector<bool> isFree = all;
        if (!forAll) {
            isFree = withNeighbours(plan_.network(), changedPatches(spacesBefore), ringsAround);
            const auto points = [&] { return static_cast<double>(FreeUnknowns(spaces_, isFree).count()); };
            const double limit = worthAll * static_cast<double>(unknownsOf(spaces_));
            for (double before = -1; points() > before && points() < std::min(minPoints, limit);) {
                before = points();
                isFree = withNeighbours(plan_.network(), isFree, 1);
            }
            if (points() > limit) isFree = all;
        }
        if (!solveFor(isFree, drafts) && isFree != all) {
            isFree = all;
            solveFor(isFree, drafts);
        }
        assess(isFree);
        reweighed_.assign(sources_.size(), false);
        solvedRuns_ = plan_.network().runs;
    }

    /// \return false if the patches do not meet those that stay
    bool solveFor(const std::vector<bool>& isFree, int drafts) {
        const auto forFree = [&](const auto& function) {
            parallelFor(sources_.size(), jobs_, [&](std::size_t k) {
                if (isFree[k]) function(k);
            });
        };
        patches_.resize(sources_.size());
        forFree([&](std::size_t k) {
            const auto parameters = parametersOf(k, spaces_[k].knots);
            if (parameters != lattices_[k].targets.parameters)
                lattices_[k] = resample(sources_[k], lattices_[k], parameters);
            releaseHolds(lattices_[k]);
        });
        SmoothSystem system(layout_, plan_.network(), spaces_, lattices_, options_.bending, isFree, patches_,
                            jobs_);
        for (int k = 0; k < drafts; ++k) {
            system.solve(lattices_, Accuracy::draft, patches_);
            forFree([&](std::size_t i) { slideTargets(patches_[i], lattices_[i]); });
        }
        system.solve(lattices_, Accuracy::rounding, patches_);
        return system.holds();
    }

    /// Measures patches anew, at the points of their lattices.
    void assess(const std::vector<bool>& isNew) {
        parallelFor(sources_.size(), jobs_, [&](std::size_t k) {
            if (!isNew[k]) return;
            errors_[k] = latticeErrors(lattices_[k], patches_[k], options_.tolerance, scale_[k]);
            missed_[k] = missedBy(errors_[k]);
            givenUp_[k].cap(lattices_[k], errors_[k]);
        });
        worst_ = 0;
        excess_ = 0;
        for (const PatchErrors& ofPatch : errors_) {
            worst_ = std::max(worst_, ofPatch.max());
            excess_ += std::max(0.0, ofPatch.max() - 1);
        }
    }

    /// Gives points that are too far away more weight, so that the largest error counts and not the mean.
    /// \return false if no weight can grow any more
    bool weighWhatIsMissed() {
        bool changed = false;
        for (std::size_t k = 0; k < lattices_.size(); ++k) {
            bool ofPatch = false;
            for (std::size_t i = 0; i < errors_[k].error.size(); ++i) {
                double& emphasis = lattices_[k].emphasis[i];
                if (errors_[k].error[i] <= 1 || emphasis >= Emphasis::max) continue;
                emphasis *= Emphasis::growth;
                ofPatch = true;
            }
            if (!ofPatch) continue;
            weighTargets(sources_[k], lattices_[k]);
            reweighed_[k] = true;
            changed = true;
        }
        return changed;
    }

    /// \return whether the round was the best so far, by either rule
    bool keepIfBest() {
        const RoundScore score = scoreOf(missed_, worst_ <= 1, patches_);
        const bool isBest = best_.patches.empty() || isBetter(score, best_.score, true);
        const bool isNearest = nearest_.patches.empty() || isBetter(score, nearest_.score, false);
        if (isBest) best_ = {score, patches_, plan_, lattices_, missed_, {}};
        if (isNearest) nearest_ = {score, patches_, plan_, lattices_, missed_, {}};
        return isBest || isNearest;
    }

    /// Takes the nearest instead where that is in truth nearer, which the lattices do not tell.
    void chooseBest(const Verification& verify) {
        if (!verify || nearest_.patches.empty()) return;
        const double ofBest = std::ranges::max(verified(best_, verify));
        if (ofBest > 1 && std::ranges::max(verified(nearest_, verify)) < ofBest) best_ = std::move(nearest_);
    }

    /// From now on errors count no more in the cells where nothing helps. The worst are given up first: what
    /// is bad beside them may be due to them.
    void giveUp() {
        constexpr double share = 0.5;
        forBadCells(1 + share * (worst_ - 1), [&](const KnotCell& cell, std::size_t k) {
            givenUp_[k].add(cell, sources_[k], lattices_[k], errors_[k]);
            reweighed_[k] = true;
        });
    }

    /// Where nothing else helps, sliding may have led astray.
    bool stopSliding() {
        constexpr double around = 2; // mesh edges
        bool changed = false;
        forBadCells(1, [&](const KnotCell& cell, std::size_t k) {
            const bool isNew = holdTargets({cell.begin[0] - around, cell.begin[1] - around},
                                           {cell.end[0] + around, cell.end[1] + around}, lattices_[k]);
            changed = changed || isNew;
        });
        return changed;
    }

    template <class Function> void forBadCells(double limit, Function&& function) {
        for (std::size_t k = 0; k < lattices_.size(); ++k)
            for (const KnotCell& cell : cellsOf(spaces_[k]))
                if (worstIn(cell, lattices_[k], errors_[k]).error > limit) function(cell, k);
    }

    const Layout& layout_;
    const SmoothFitOptions& options_;
    unsigned jobs_;
    StretchMap map_;
    KnotPlan plan_;
    std::vector<std::optional<Plane>> planes_;
    std::vector<LatticeSource> sources_;
    std::vector<FitLattice> lattices_;
    std::vector<PatchSpace> spaces_;
    std::vector<Patch> patches_;
    std::vector<PatchErrors> errors_;
    std::vector<GivenUpCells> givenUp_;
    std::vector<bool> reweighed_;       ///< by patch: since the last solution
    std::vector<SmoothRun> solvedRuns_; ///< of the last solution
    std::vector<double> missed_; ///< by patch: how much its largest error is above 1, whatever is given up
    double worst_ = 0;
    double excess_ = 0;
    std::vector<double> scale_; ///< by patch: how much its errors count
    FitRound best_;
    FitRound nearest_; ///< the same, if what is given up counts as all else does
};

} // namespace

std::vector<Patch> fitSmooth(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                             const FitTarget& reference, const SmoothFitOptions& options,
                             const Verification& verify, const Control& control) {
    if (layout.segments.empty()) return {};
    return SmoothFit(mesh, layout, network, reference, options, control.jobs).run(verify, control);
}

} // namespace qm

#include "bspline/fitting/fit_state.h"

#include "base/parallel.h"
#include "bspline/fitting/knots/knot_insertion.h"
#include "bspline/fitting/lattice/lattice_cells.h"
#include "bspline/fitting/lattice/lattice_holds.h"
#include "bspline/fitting/planes/group_flattening.h"
#include "bspline/fitting/system/continuity_equations.h"
#include "bspline/fitting/system/free_patches.h"
#include "bspline/fitting/system/smooth_system.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace qm {
namespace {

/// The weight of a point grows by `growth` per round, up to `max`.
struct Emphasis {
    static constexpr double growth = 3;
    static constexpr double max = 100;
};

} // namespace

FitState::FitState(const FitProblem& problem, const SmoothFitOptions& options,
                   const std::vector<bool>& isSoft, unsigned jobs)
    : setup_(problem, options, isSoft, jobs), plan_(setup_.planWithoutKnots), lattices_(count()),
      kept_(count()), errors_(count(), options.tolerance), reweighed_(count()) {}

/// Marks the patches whose knots, weights or tangent ratios have changed since the last solution.
std::vector<bool> FitState::changedPatches(const std::vector<PatchSpace>& before) const {
    std::vector<bool> changed = reweighed_;
    for (std::size_t k = 0; k < count(); ++k)
        if (spaces_[k].knots != before[k].knots) changed[k] = true;
    for (std::size_t k = 0; k < solvedRuns_.size(); ++k)
        if (const SmoothRun& run = plan_.runs()[k]; run.ratio != solvedRuns_[k].ratio)
            for (const StretchSide& side : plan_.stretches()[run.stretch].sides)
                changed[side.patch] = true;
    return changed;
}

bool FitState::isSolvedWith(const KnotPlan& plan) const {
    const std::vector<PatchSpace> spaces = plan.spaces();
    return std::ranges::equal(spaces, spaces_, {}, &PatchSpace::knots, &PatchSpace::knots) &&
           std::ranges::equal(plan.runs(), solvedRuns_, {}, &SmoothRun::ratio, &SmoothRun::ratio);
}

void FitState::begin(KnotPlan plan, std::vector<FitLattice> lattices, int slides) {
    takeKnots(std::move(plan));
    lattices_ = std::move(lattices);
    spaces_ = plan_.spaces();
    solveFor(everywhere(), slides);
}

void FitState::beginAnew(int slides) {
    const auto begin = [&](const std::vector<bool>& isFree) {
        parallelFor(count(), setup_.jobs, [&](std::size_t k) {
            if (isFree[k]) changing(k) = setup_.evenLattice(k);
        });
        return solveFor(isFree, slides);
    };
    if (!begin(freeAround([](const PatchErrors& errors) { return errors.anyFolded(); }))) begin(everywhere());
}

void FitState::beginFrom(const FitRound& round, const std::vector<bool>& isSoft, int slides) {
    restore(round);
    for (std::size_t k = 0; k < count(); ++k) {
        if (!isSoft[k]) continue;
        changing(k) = makeLattice(setup_.sources[k], setup_.parametersOf(k, spaces_[k].knots));
        errors_.giveNothingUp(k);
        reweighed_[k] = true;
    }
    solveChanged(slides);
}

void FitState::solveChanged(int slides) {
    const std::vector<bool> isFree = freeAround([](const PatchErrors& errors) { return errors.max() > 1; });
    if (!solveFor(isFree, slides)) solveFor(everywhere(), slides);
}

/// Makes the spaces of the plan, and marks the patches to solve for: those that have changed since the last
/// solution or whose errors are of some kind, and patches around them.
template <class OfKind> std::vector<bool> FitState::freeAround(const OfKind& isOfKind) {
    const std::vector<PatchSpace> before = std::exchange(spaces_, plan_.spaces());
    std::vector<bool> changed = changedPatches(before);
    for (std::size_t k = 0; k < count(); ++k)
        if (isOfKind(errors_.ofPatches()[k])) changed[k] = true;
    return freePatches(plan_.stretches(), spaces_, changed, setup_.options.ringsAround,
                       setup_.options.worthAll);
}

/// Solves for the free patches, and measures them.
/// \return false if only some patches are free and these cannot meet the others; then no target has slid
bool FitState::solveFor(const std::vector<bool>& isFree, int slides) {
    const auto forFree = [&](const auto& function) {
        parallelFor(count(), setup_.jobs, [&](std::size_t k) {
            if (isFree[k]) function(k);
        });
    };
    patches_.resize(count());
    forFree([&](std::size_t k) {
        const auto parameters = setup_.parametersOf(k, spaces_[k].knots);
        FitLattice& lattice = changing(k);
        if (parameters != lattice.targets.parameters)
            lattice = resample(setup_.sources[k], lattice, parameters);
        releaseHolds(lattice);
    });
    SmoothSystem system(plan_, spaces_, lattices_, setup_.plates, isFree, patches_, setup_.jobs);
    if (isFree != everywhere()) {
        system.solve(lattices_, Accuracy::rounding, patches_);
        if (!system.holds()) return false;
    }
    for (int k = 0; k < slides; ++k) {
        system.solve(lattices_, Accuracy::draft, patches_);
        forFree([&](std::size_t i) {
            const double share = errors_.isScaled(i) ? 0 : setup_.options.slack;
            slideTargets(patches_[i], share * setup_.options.tolerance, lattices_[i]);
        });
    }
    system.solve(lattices_, Accuracy::rounding, patches_);
    assess(isFree);
    reweighed_.assign(count(), false);
    solvedRuns_ = plan_.runs();
    return true;
}

FitRound FitState::round() {
    for (std::size_t k = 0; k < lattices_.size(); ++k)
        if (!kept_[k]) kept_[k] = std::make_shared<const LatticeProgress>(lattices_[k]);
    return {score(), patches_, plan_, kept_, errors_.givenUp(), {}};
}

FitLattice& FitState::changing(std::size_t patch) {
    kept_[patch].reset();
    return lattices_[patch];
}

void FitState::restore(const FitRound& round) {
    plan_ = *round.plan;
    spaces_ = plan_.spaces();
    parallelFor(count(), setup_.jobs, [&](std::size_t k) {
        if (kept_[k] != round.lattices[k]) lattices_[k] = restored(setup_.sources[k], *round.lattices[k]);
    });
    kept_ = round.lattices;
    errors_.setGivenUp(round.givenUp);
    reweighed_.assign(count(), false);
    patches_ = round.patches;
    solvedRuns_ = plan_.runs();
    assess(everywhere());
}

bool FitState::flatten(std::vector<std::optional<FlatPatch>>& planes, int slides) {
    if (!qm::flatten(plan_, planes, patches_, setup_.jobs)) return false;
    std::vector<bool> isFree(planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k)
        isFree[k] = planes[k].has_value();
    isFree = withNeighbours(plan_.stretches(), std::move(isFree), setup_.options.ringsAround);
    for (std::size_t k = 0; k < planes.size(); ++k)
        if (planes[k]) isFree[k] = false;
    std::vector<Patch> flat = patches_;
    if (!solveFor(isFree, slides)) patches_ = std::move(flat);
    assess(everywhere());
    return true;
}

bool FitState::weighWhatIsMissed() {
    bool changed = false;
    for (std::size_t k = 0; k < lattices_.size(); ++k) {
        bool ofPatch = false;
        const std::vector<double>& error = errors_.ofPatches()[k].error;
        for (std::size_t i = 0; i < error.size(); ++i) {
            if (error[i] <= 1 || lattices_[k].emphasis[i] >= Emphasis::max) continue;
            changing(k).emphasis[i] *= Emphasis::growth;
            ofPatch = true;
        }
        if (ofPatch) reweigh(k);
        changed = changed || ofPatch;
    }
    return changed;
}

/// Sets a patch's weights to its emphasis.
void FitState::reweigh(std::size_t patch) {
    weighTargets(setup_.sources[patch], changing(patch));
    reweighed_[patch] = true;
}

bool FitState::refine() {
    return qm::refine(lattices_, setup_.map, spaces_, errors_.ofPatches(), plan_);
}

template <class Function> void FitState::forBadCells(double limit, Function&& function) {
    for (std::size_t k = 0; k < lattices_.size(); ++k)
        for (const KnotCell& cell : cellsOf(spaces_[k]))
            if (worstIn(cell, lattices_[k], errors_.ofPatches()[k]).error > limit) function(cell, k);
}

bool FitState::removeKnots() {
    removed_ = qm::removeKnots(lattices_, setup_.normalLimits, patches_, errors_.ofPatches(),
                               setup_.options.tolerance, plan_);
    return !removed_.empty();
}

bool FitState::putBackKnots(Where where) {
    std::vector<std::vector<KnotCell>> missed(count());
    std::vector<bool> patches(count());
    forBadCells(1, [&](const KnotCell& cell, std::size_t k) {
        missed[k].push_back(cell);
        patches[k] = true;
    });
    if (where == Where::aroundPatches) patches = withNeighbours(plan_.stretches(), std::move(patches), 1);
    const auto comesBack = [&](const PatchKnot& removed) {
        if (where != Where::inCells) return static_cast<bool>(patches[removed.patch]);
        return std::ranges::any_of(missed[removed.patch], [&](const KnotCell& cell) {
            return cell.begin[removed.direction] < removed.knot && removed.knot < cell.end[removed.direction];
        });
    };
    return std::erase_if(removed_, [&](const PatchKnot& removed) {
               if (!comesBack(removed)) return false;
               plan_.insert(removed.patch, removed.direction, removed.knot);
               return true;
           }) > 0;
}

void FitState::giveUpCells(double limit, BadCells which) {
    std::vector<bool> changed(count());
    forBadCells(limit, [&](const KnotCell& cell, std::size_t k) {
        if (which == BadCells::foldedOnly && !isNear(cell, lattices_[k], errors_.ofPatches()[k])) return;
        errors_.giveUp(k, cell, changing(k));
        changed[k] = true;
    });
    for (std::size_t k = 0; k < changed.size(); ++k)
        if (changed[k]) reweigh(k);
}

void FitState::giveUp() {
    constexpr double share = 0.5;
    giveUpCells(1 + share * (errors_.worst() - 1), BadCells::any);
}

void FitState::giveUpFolds() {
    giveUpCells(1, BadCells::foldedOnly);
}

bool FitState::stopSliding() {
    constexpr double around = 2; // mesh edges
    std::vector<std::vector<KnotCell>> held(lattices_.size());
    forBadCells(1, [&](const KnotCell& cell, std::size_t k) {
        held[k].push_back(
            {{cell.begin[0] - around, cell.begin[1] - around}, {cell.end[0] + around, cell.end[1] + around}});
    });
    bool changed = false;
    for (std::size_t k = 0; k < held.size(); ++k)
        if (!held[k].empty() && holdTargets(held[k], changing(k))) changed = true;
    return changed;
}

bool FitState::tighten(const FitRound& round) {
    if (!errors_.tighten(round.distances)) return false;
    assess(everywhere());
    return true;
}

} // namespace qm

/// \file The state of a fit: its knots, the patches fitted with them, and their distances from the reference.
#pragma once

#include "bspline/fitting/fit_errors.h"
#include "bspline/fitting/fit_problem.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/fit_setup.h"
#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/knots/knot_removal.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/planes/flat_patches.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace qm {

/// The steps of a fit.
class FitState {
public:
    /// Without knots and patches; `begin` or `beginFrom` comes first. The arguments must outlive it.
    /// \param isSoft  by patch: whether it follows the reference more closely at the cost of fairness
    FitState(const FitProblem& problem, const SmoothFitOptions& options, const std::vector<bool>& isSoft,
             unsigned jobs);

    [[nodiscard]] const FitSetup& setup() const { return setup_; }

    /// Solves for all patches with the knots of a plan.
    /// \param lattices  of equal steps
    void begin(KnotPlan plan, std::vector<FitLattice> lattices, int slides);
    /// Changes the knots; the patches remain until they are solved for.
    void takeKnots(KnotPlan plan) { plan_ = std::move(plan); }
    /// Draws the folded patches, those whose knots have changed, and those around them to the reference,
    /// without what was learnt before, and solves for them, or does so with all if that is impossible.
    void beginAnew(int slides);
    /// Goes on from a round of another fit, but draws soft patches to the reference without what was learnt
    /// of them, and solves for these.
    void beginFrom(const FitRound& round, const std::vector<bool>& isSoft, int slides);
    /// Solves for the patches that have changed and those around them, or for all if that is impossible.
    void solveChanged(int slides);

    [[nodiscard]] const FitErrors& errors() const { return errors_; }
    [[nodiscard]] RoundScore score() const { return errors_.scoreOf(patches_); }

    /// Whether the present patches have a plan's knots and tangent ratios.
    [[nodiscard]] bool isSolvedWith(const KnotPlan& plan) const;
    [[nodiscard]] FitRound round();
    /// Goes back to an earlier round.
    void restore(const FitRound& round);

    /// Moves plane patches into their planes, solves for the others around them, and measures all again.
    /// \param planes  by patch; those that cannot be reached are dropped
    /// \return false if no point was moved, since all were in their planes or none can be; then no patch has
    /// changed
    bool flatten(std::vector<std::optional<FlatPatch>>& planes, int slides);

    /// Increases the weights of points that are too far away, so that the largest error decides and not the
    /// mean.
    /// \return false if no weight may grow any more
    bool weighWhatIsMissed();
    /// Divides knot intervals in which points are too far away.
    /// \return false if there was nothing to divide
    bool refine();
    /// Where nothing else has helped, sliding may be the cause: stops it there.
    /// \return false if it was stopped there before
    bool stopSliding();
    /// \return false if intervals as short as these were allowed before
    bool allow(MinInterval length) { return plan_.allow(length); }
    /// From now on ignores the errors of cells in which nothing has helped. The worst are given up first,
    /// since they may be the cause of errors beside them.
    void giveUp();
    /// Gives up cells that are folded but near enough.
    void giveUpFolds();
    /// Removes knots that seem not to be needed.
    /// \return false if there are none
    bool removeKnots();
    /// Where points are too far away: in the rows and columns of their cells, in their patches, or in these
    /// and those around them.
    enum class Where { inCells, inPatches, aroundPatches };
    /// Puts back the knots removed last, there.
    /// \return false if there were none
    bool putBackKnots(Where where);

    /// Where a verification found a patch farther away than its lattice shows, scales the errors of this
    /// patch from now on so that the largest equals what was found.
    /// \param round  the present one, with verified distances
    /// \return false if there is no such patch
    bool tighten(const FitRound& round);

private:
    [[nodiscard]] std::size_t count() const { return setup_.sources.size(); } ///< of patches
    [[nodiscard]] std::vector<bool> everywhere() const { return std::vector<bool>(count(), true); }
    [[nodiscard]] std::vector<bool> changedPatches(const std::vector<PatchSpace>& before) const;
    template <class OfKind> std::vector<bool> freeAround(const OfKind& isOfKind);
    bool solveFor(const std::vector<bool>& isFree, int slides);
    FitLattice& changing(std::size_t patch);
    /// Measures patches again.
    void assess(const std::vector<bool>& isNew) { errors_.measure(isNew, lattices_, patches_, setup_.jobs); }
    template <class Function> void forBadCells(double limit, Function&& function);
    enum class BadCells { any, foldedOnly };
    void giveUpCells(double limit, BadCells which);
    void reweigh(std::size_t patch);

    FitSetup setup_;
    KnotPlan plan_;
    std::vector<FitLattice> lattices_;
    /// By patch: a shared copy of its lattice's progress, if the lattice has not changed since.
    std::vector<std::shared_ptr<const LatticeProgress>> kept_;
    std::vector<PatchSpace> spaces_;
    std::vector<Patch> patches_;
    FitErrors errors_;
    std::vector<bool> reweighed_;       ///< by patch: whether weights have changed since the last solution
    std::vector<SmoothRun> solvedRuns_; ///< the runs with the tangent ratios of the last solution
    std::vector<PatchKnot> removed_;    ///< the last time, and not put back
};

} // namespace qm

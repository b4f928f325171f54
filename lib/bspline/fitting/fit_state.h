/// \file Where a fit stands: its knots, the patches that were fitted with them, and how far these are away.
#pragma once

#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/given_up_cells.h"
#include "bspline/fitting/knot_plan.h"
#include "bspline/fitting/lattice_errors.h"
#include "bspline/fitting/normal_limits.h"
#include "bspline/fitting/thin_plate.h"
#include "bspline/network/stretch_map.h"
#include "bspline/reference/fit_target.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace qm {

struct SmoothFitOptions;

/// The steps that a fit is made of. Errors are in tolerances: more than 1 is too far away.
class FitState {
public:
    /// Begins with the fewest knots that are likely to do, and without patches. What is passed must outlive
    /// it.
    /// \param isSoft  patches that are to follow the reference rather than be fair
    FitState(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
             const FitTarget& reference, const SmoothFitOptions& options, const std::vector<bool>& isSoft,
             unsigned jobs);

    /// Solves for what has changed, with what lies around it, or for all.
    /// \param slides  how often the targets move in between
    void solve(int slides, bool forAll);

    [[nodiscard]] double worst() const { return worst_; }   ///< error of all patches
    [[nodiscard]] double excess() const { return excess_; } ///< what patches err above 1, in sum

    /// What this has come to.
    [[nodiscard]] RoundScore score() const;
    /// \param isKept  for restoring it; else without the lattices, which are large
    [[nodiscard]] FitRound round(bool isKept);
    /// Goes back to an earlier round.
    void restore(const FitRound& round);

    /// Gives points that are too far away more weight, so that the largest error counts and not the mean.
    /// \return false if no weight can grow any more
    bool weighWhatIsMissed();
    /// Divides knot intervals where points are too far away.
    /// \return false if there was nothing to divide
    bool refine();
    /// Where nothing else helps, sliding may have led astray: forbids it there.
    /// \return false if that has been done
    bool stopSliding();
    /// \return false if that has been done
    bool allowShorterIntervals() { return plan_.allowShorter(); }
    /// From now on errors count no more in the cells where nothing helps. The worst are given up first: what
    /// is bad beside them may be due to them.
    void giveUp();
    /// The same where patches are folded, but near enough.
    void giveUpFolds();
    /// Removes knots that can be done without.
    /// \return how many
    std::size_t removeKnots();

    /// Errors of patches that are farther away than their lattices tell count so much more from now on that
    /// the largest is what was found.
    /// \param round  the present one, with verified distances
    /// \return false if there are none
    bool tighten(const FitRound& round);

private:
    [[nodiscard]] std::vector<bool> everywhere() const { return std::vector<bool>(sources_.size(), true); }
    [[nodiscard]] std::array<std::vector<double>, 2>
    parametersOf(std::size_t patch, const std::array<std::vector<double>, 2>& knots) const;
    [[nodiscard]] std::vector<bool> changedPatches(const std::vector<PatchSpace>& before) const;
    [[nodiscard]] std::vector<bool> patchesToSolveFor(const std::vector<PatchSpace>& before) const;
    bool solveFor(const std::vector<bool>& isFree, int slides);
    FitLattice& changing(std::size_t patch);
    void assess(const std::vector<bool>& isNew);
    template <class Function> void forBadCells(double limit, Function&& function);
    void giveUp(const KnotCell& cell, std::size_t patch);

    const Layout& layout_;
    const SmoothFitOptions& options_;
    unsigned jobs_;
    StretchMap map_;
    KnotPlan plan_;
    std::vector<LatticeSource> sources_;
    std::vector<NormalLimits> normalLimits_;
    std::vector<std::vector<ThinPlate>> plates_; ///< by patch and quad
    std::vector<FitLattice> lattices_;
    std::vector<std::shared_ptr<const LatticeProgress>> kept_; ///< by patch: its lattice's; or none yet
    std::vector<PatchSpace> spaces_;
    std::vector<Patch> patches_;
    std::vector<PatchErrors> errors_;
    std::vector<GivenUpCells> givenUp_;
    std::vector<bool> reweighed_;       ///< by patch: since the last solution
    std::vector<SmoothRun> solvedRuns_; ///< of the last solution
    std::vector<double> missed_; ///< by patch: how much its largest error is above 1, whatever is given up
    std::vector<double> scale_;  ///< by patch: how much its errors count
    double worst_ = 0;
    double excess_ = 0;
};

} // namespace qm

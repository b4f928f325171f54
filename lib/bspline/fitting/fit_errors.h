/// \file How far the patches of a fit are from the reference, at the points of their lattices.
#pragma once

#include "bspline/fitting/fit_round.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/given_up_cells.h"
#include "bspline/fitting/lattice/lattice_cells.h"
#include "bspline/fitting/lattice/lattice_errors.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Errors are in tolerances: values above 1 are too large.
class FitErrors {
public:
    FitErrors(std::size_t patches, double tolerance)
        : tolerance_(tolerance), ofPatch_(patches), givenUp_(patches), missed_(patches), scale_(patches, 1) {}

    /// Measures the patches that are new.
    void measure(const std::vector<bool>& isNew, const std::vector<FitLattice>& lattices,
                 const std::vector<Patch>& patches, unsigned jobs);

    [[nodiscard]] const std::vector<PatchErrors>& ofPatches() const { return ofPatch_; }
    [[nodiscard]] double worst() const { return worst_; }   ///< largest error of all patches
    [[nodiscard]] double excess() const { return excess_; } ///< sum over the patches of their error above 1

    /// By patch: whether its error is above 1.
    [[nodiscard]] std::vector<bool> areMissed() const;
    /// By patch: whether it is folded where that counts.
    [[nodiscard]] std::vector<bool> areFolded() const;
    [[nodiscard]] bool isAnyFolded() const;
    [[nodiscard]] RoundScore scoreOf(const std::vector<Patch>& patches) const;

    /// From now on ignores the error of a cell, unless it grows.
    void giveUp(std::size_t patch, const KnotCell& cell, FitLattice& lattice) {
        givenUp_[patch].add(cell, lattice, ofPatch_[patch]);
    }
    /// By patch: what is given up.
    [[nodiscard]] const std::vector<GivenUpCells>& givenUp() const { return givenUp_; }
    /// Gives up these cells and no others, from the next measurement on.
    void setGivenUp(std::vector<GivenUpCells> cells) { givenUp_ = std::move(cells); }
    void giveNothingUp(std::size_t patch) { givenUp_[patch] = {}; }

    /// Where a verification found a patch farther away than its lattice shows, scales its errors so that the
    /// largest equals what was found, from the next measurement on.
    /// \param distances  by patch, as verified
    /// \return false if there is no such patch
    bool tighten(const std::vector<double>& distances);
    [[nodiscard]] bool isScaled(std::size_t patch) const { return scale_[patch] > 1; }

private:
    double tolerance_;
    std::vector<PatchErrors> ofPatch_;
    std::vector<GivenUpCells> givenUp_; ///< by patch
    std::vector<double> missed_;        ///< by patch: its excess before anything is given up
    std::vector<double> scale_;         ///< by patch: factor of its errors
    double worst_ = 0;
    double excess_ = 0;
};

} // namespace qm

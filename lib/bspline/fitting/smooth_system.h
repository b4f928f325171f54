/// \file The one system of all patches, or of some while the others stay, set up and solved.
#pragma once

#include "bspline/fitting/constrained_system.h"
#include "bspline/fitting/fit_lattice.h"
#include "bspline/fitting/thin_plate.h"
#include "bspline/network/smooth_network.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <optional>
#include <vector>

namespace qm {

/// Finds the patches in these spaces that come nearest to the targets of the lattices, and bend little, among
/// those that meet along all stretches and are smooth along all runs. Factorised once for given weights; the
/// targets may move between solutions.
class SmoothSystem {
public:
    /// \param lattices  their weights count, not where their targets are
    /// \param plates  by patch and quad
    /// \param isFree  by patch
    /// \param patches  those that are not free stay as they are here, and have these spaces
    SmoothSystem(const Layout& layout, const SmoothNetwork& network, const std::vector<PatchSpace>& spaces,
                 const std::vector<FitLattice>& lattices, const std::vector<std::vector<ThinPlate>>& plates,
                 const std::vector<bool>& isFree, const std::vector<Patch>& patches, unsigned jobs);

    /// Makes free patches those for the targets that the lattices have now.
    void solve(const std::vector<FitLattice>& lattices, Accuracy accuracy, std::vector<Patch>& patches);

    /// Whether the patches of the last solution meet each other and those that stay but for rounding. Where
    /// the equations contradict one another beside what stays, the solution is anything, and large.
    [[nodiscard]] bool holds() const;

private:
    std::vector<std::size_t> free_;  ///< patches
    std::vector<PatchSpace> spaces_; ///< theirs, with the numbers of free unknowns
    Eigen::Index unknowns_ = 0;      ///< free ones
    double size_ = 0;                ///< largest coordinate of what they are to approximate
    unsigned jobs_;
    std::optional<ConstrainedSystem> system_;
    Eigen::MatrixX3d solution_; ///< the last one, where the next one begins
};

} // namespace qm

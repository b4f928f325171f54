/// \file Sets up and solves the one system for all patches, or for some while the others stay as they are.
#pragma once

#include "bspline/fitting/energy/thin_plate.h"
#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/solver/constrained_system.h"
#include "bspline/splines/surfaces.h"

#include <optional>
#include <vector>

namespace qm {

/// Finds the patches of given spline spaces that are nearest to the targets of the lattices and bend least,
/// among those that meet along all stretches and are G1 along all smooth runs. It is factorised once for
/// given weights; the targets may move between solutions.
class SmoothSystem {
public:
    /// \param lattices  their weights are used, not the positions of their targets
    /// \param plates    by patch and quad
    /// \param isFree    by patch
    /// \param patches   those that are not free stay as they are and have the given spaces
    SmoothSystem(const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                 const std::vector<FitLattice>& lattices, const std::vector<std::vector<ThinPlate>>& plates,
                 const std::vector<bool>& isFree, const std::vector<Patch>& patches, unsigned jobs);

    /// Solves for the lattices' present targets and replaces the free patches.
    void solve(const std::vector<FitLattice>& lattices, Accuracy accuracy, std::vector<Patch>& patches);

    /// Whether the patches of the last solution meet each other, and those that stay, up to rounding. If the
    /// equations contradict what stays, the solution is meaningless and large.
    [[nodiscard]] bool holds() const;

private:
    std::vector<std::size_t> free_;  ///< the free patches
    std::vector<PatchSpace> spaces_; ///< their spline spaces, with the numbers of the free unknowns
    Eigen::Index unknowns_ = 0;      ///< number of free unknowns
    double size_ = 0;                ///< largest coordinate of the targets
    unsigned jobs_;
    std::optional<ConstrainedSystem> system_;
    Eigen::MatrixX3d solution_; ///< the last solution, from which the next one starts
};

} // namespace qm

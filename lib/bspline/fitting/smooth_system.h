/// \file The one system of all patches, set up and solved.
#pragma once

#include "base/control.h"
#include "bspline/fitting/constrained_system.h"
#include "bspline/fitting/fit_lattice.h"
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
    /// \param bending  weight of the thin-plate energy over the parameters, of every patch
    SmoothSystem(const Layout& layout, const SmoothNetwork& network, std::vector<PatchSpace> spaces,
                 const std::vector<FitLattice>& lattices, double bending, unsigned jobs);

    /// \return the patches for the targets that the lattices have now
    [[nodiscard]] std::vector<Patch> solve(const std::vector<FitLattice>& lattices, Accuracy accuracy);

    [[nodiscard]] const std::vector<PatchSpace>& spaces() const { return spaces_; }

private:
    std::vector<PatchSpace> spaces_;
    unsigned jobs_;
    std::optional<ConstrainedSystem> system_;
    Eigen::MatrixX3d solution_; ///< the last one, where the next one begins
};

} // namespace qm

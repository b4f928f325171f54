/// \file The one system of all patches, set up and solved.
#pragma once

#include "base/control.h"
#include "bspline/fitting/fit_lattice.h"
#include "bspline/network/smooth_network.h"
#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <vector>

namespace qm {

/// The patches in these spaces that come nearest to the targets of the lattices, and bend little, among those
/// that meet along all stretches and are smooth along all runs.
/// \param bending  weight of the thin-plate energy over the parameters, of every patch
[[nodiscard]] std::vector<Patch> solveSmooth(const Layout& layout, const SmoothNetwork& network,
                                             const std::vector<PatchSpace>& spaces,
                                             const std::vector<FitLattice>& lattices, double bending,
                                             unsigned jobs);

} // namespace qm

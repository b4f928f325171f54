/// \file The continuity equations of all surfaces of a layout.
#pragma once

#include "bspline/fitting/knots/knot_plan.h"
#include "bspline/network/border_strip.h"

#include <cstddef>
#include <vector>

namespace qm {

/// C0 along all stretches and G1 along all smooth runs: each form must be 0 in every coordinate.
/// \param plan    of the network, with the runs' ratios
/// \param isFree  by patch; equations between patches that are not free are left out
[[nodiscard]] std::vector<LinearForm> continuityEquations(const KnotPlan& plan,
                                                          const std::vector<PatchSpace>& spaces,
                                                          const std::vector<bool>& isFree);

/// The number of control points of all patches.
[[nodiscard]] std::size_t unknownsOf(const std::vector<PatchSpace>& spaces);

} // namespace qm

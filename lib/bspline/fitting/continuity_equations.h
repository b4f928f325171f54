/// \file All equations of a layout's surfaces together.
#pragma once

#include "bspline/network/border_strip.h"
#include "bspline/network/smooth_network.h"
#include "layout/layout.h"

#include <cstddef>
#include <vector>

namespace qm {

/// C0 along all stretches, G1 along all smooth runs: each form is to be 0, for every coordinate.
/// \param isFree  by patch: those between patches that are not are left out
[[nodiscard]] std::vector<LinearForm> continuityEquations(const Layout& layout, const SmoothNetwork& network,
                                                          const std::vector<PatchSpace>& spaces,
                                                          const std::vector<bool>& isFree);

/// Control points of all patches.
[[nodiscard]] std::size_t unknownsOf(const std::vector<PatchSpace>& spaces);

} // namespace qm

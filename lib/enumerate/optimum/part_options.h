/// \file The task and the limits of a search for the cheapest graphs.
#pragma once

#include "base/infinity.h"

#include <cstddef>
#include <limits>

namespace qm {

struct PartOptions {
    /// A limit that is never reached.
    static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

    std::size_t best = 1; ///< how many of the cheapest graphs to find
    double maxCost = infinity;
    double gap = 0; ///< stop when cost less lower bound is at most this
    /// Limit of the search tree of each part; the default is what fits into memory.
    std::size_t nodes = 20'000'000;
    /// Limit of the simplex method's work in all parts together, see `Relaxation::work`. Of what is left,
    /// every part gets a share by its size.
    std::size_t work = never;
    /// From this number of variables on a part is hard, and smaller searches look for early graphs.
    std::size_t hard = 1500;
    /// From this number of variables on, cuts are added to the relaxation; smaller parts are proven as fast
    /// without.
    std::size_t cut = 300;
    /// From this number of variables on, only the root of a part is searched, and its relaxation begins with
    /// gradients, because the simplex method alone would take too long. Needs a start.
    std::size_t large = never;
    /// Accuracy of these gradients. Before the simplex method, more digits would take longer than it needs.
    double nearlySolved = 2e-2;
};

} // namespace qm

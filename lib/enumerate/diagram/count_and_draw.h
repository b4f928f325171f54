/// \file How many graphs a decision diagram holds, and the one of every rank.
#pragma once

#include "base/big_count.h"
#include "enumerate/diagram/diagram.h"

#include <vector>

namespace qm {

/// The number of paths from every node to the end.
[[nodiscard]] std::vector<BigCount> countWays(const Diagram& diagram);

/// The number of graphs that cost at most `maxCost`. Walks from node to node, but not below nodes where all
/// paths are cheap enough, or none is.
/// \return nothing if `control.stopRequested` ended it
[[nodiscard]] std::optional<BigCount> countUpTo(const Diagram& diagram, double maxCost,
                                                const Control& control = {});

/// The graph of a rank, 0 to the number of graphs less 1; different ranks give different graphs.
/// \param ways  what `countWays` returns
[[nodiscard]] Assignment graphOfRank(const Diagram& diagram, const std::vector<BigCount>& ways,
                                     BigCount rank);

/// Draws graphs uniformly, with repetition. The same seed gives the same graphs everywhere.
[[nodiscard]] std::vector<Assignment> drawGraphs(const Diagram& diagram, std::size_t count, std::size_t seed);

} // namespace qm

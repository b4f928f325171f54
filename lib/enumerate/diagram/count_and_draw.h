/// \file Counting the graphs of a decision diagram, and drawing graphs by their rank.
#pragma once

#include "base/big_count.h"
#include "enumerate/diagram/diagram.h"

#include <vector>

namespace qm {

/// For every node the number of paths to the end.
[[nodiscard]] std::vector<BigCount> countPaths(const Diagram& diagram);

/// The number of graphs that cost at most `maxCost`. The walk turns back at nodes below which all paths are
/// cheap enough, or none is.
/// \return nothing if `control.stopRequested` ended the walk
[[nodiscard]] std::optional<BigCount> countUpTo(const Diagram& diagram, double maxCost,
                                                const Control& control = {});

/// The graph of a rank from 0 to the number of graphs less 1; different ranks have different graphs.
/// \param paths  the result of `countPaths`
[[nodiscard]] Assignment graphOfRank(const Diagram& diagram, const std::vector<BigCount>& paths,
                                     BigCount rank);

/// Draws graphs uniformly, with repetition. The same seed gives the same graphs everywhere.
[[nodiscard]] std::vector<Assignment> drawGraphs(const Diagram& diagram, std::size_t count, std::size_t seed);

} // namespace qm

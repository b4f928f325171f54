/// \file The exact number of motorcycle graphs, and graphs drawn at random
/// (docs/METHOD.md#decision-diagrams).
#pragma once

#include "base/big_count.h"
#include "enumerate/diagram/diagram.h"

#include <vector>

namespace qm {

/// The number of graphs, from a decision diagram or, if that would be too large, by `countByParts`.
/// \return nothing if `control.stopRequested` ended the count
[[nodiscard]] std::optional<BigCount> countGraphs(const Problem& problem, const Control& control = {});

/// The same without a diagram: decides one variable, counts the independent parts that remain one by one, and
/// multiplies their counts. Memory is linear in the problem where it falls apart soon, and quadratic at
/// worst.
[[nodiscard]] std::optional<BigCount> countByParts(const Problem& problem, const Control& control = {});

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

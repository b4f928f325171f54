/// \file The graphs of a decision diagram in order of cost by the algorithm of Eppstein 1998
/// (docs/METHOD.md#eppstein-1998).
#pragma once

#include "enumerate/diagram/diagram.h"

#include <functional>
#include <vector>

namespace qm {

/// The cost of the cheapest path from every node to the end; infinity from `none`.
[[nodiscard]] std::vector<double> cheapestWays(const Diagram& diagram);

/// Calls `visit` with every graph, the cheapest first, ties (up to 65,536 of them) in lexicographic order of
/// the variables, until it returns false. Time per graph is linear in
/// its length, but for a logarithm; memory grows by a few words per graph. Costs are true to rounding.
void forEachRankedGraph(const Diagram& diagram,
                        const std::function<bool(double cost, const Assignment& graph)>& visit);

} // namespace qm

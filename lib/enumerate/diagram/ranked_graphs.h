/// \file The graphs of a decision diagram in order of cost, by the algorithm of Eppstein 1998
/// (docs/METHOD.md#eppstein-1998).
#pragma once

#include "enumerate/diagram/diagram.h"

#include <functional>

namespace qm {

/// Calls `visit` with every graph, cheapest first, until it returns false. Ties (up to 65,536 of them) are in
/// lexicographic order of the variables. Time per graph is linear in its length, up to a logarithm; memory
/// grows by a few words per graph. Costs are exact up to rounding.
void forEachRankedGraph(const Diagram& diagram,
                        const std::function<bool(double cost, const Assignment& graph)>& visit);

} // namespace qm

/// \file The graphs of a decision diagram in order of cost, by the algorithm of Eppstein 1998
/// (docs/METHOD.md#eppstein-1998).
#pragma once

#include "base/control.h"
#include "enumerate/diagram/diagram.h"

#include <functional>

namespace qm {

/// Calls `visit` with every graph, cheapest first, until it returns false. Ties are in lexicographic order of
/// the variables, as many of them as 64 MB hold. Time per graph is linear in its length, up to a logarithm;
/// memory grows by a few words per graph. Costs are exact up to rounding.
/// \return false if `control.stopRequested` ended it, after what was found until then
bool forEachRankedGraph(const Diagram& diagram,
                        const std::function<bool(double cost, const Assignment& graph)>& visit,
                        const Control& control = {});

} // namespace qm

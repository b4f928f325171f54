/// \file Trail cuts of the relaxation: wherever a particle arrives, some particle goes on
/// (docs/METHOD.md#trail-cuts).
#pragma once

#include "enumerate/relaxation/pass_graph.h"

#include <vector>

namespace qm {

/// A particle that arrives at a crossing passes it or is stopped by one that passes, and whoever passes
/// arrives at the next crossing. So the trail from an arrival leaves every set of crossings in which it
/// cannot go round in a cycle: at least one pass is taken among those that lead out of the set or would close
/// a cycle in it.
/// \param values  of every column of the formulation
/// \param price   added to the value of every pass: the higher, the fewer passes a row has, and the fewer
/// rows are found
/// \return rows that every graph satisfies and these values violate
[[nodiscard]] std::vector<Formulation::Row> brokenTrails(const PassGraph& graph, const ColumnValues& values,
                                                         double price);

} // namespace qm

/// \file Cuts of the relaxation: where a particle arrives, somebody goes on (docs/METHOD.md#trail-cuts).
#pragma once

#include "enumerate/optimum/pass_graph.h"

#include <vector>

namespace qm {

/// A particle that arrives at a crossing passes it, or another one does that stops it; and whoever passes
/// arrives at the next crossing. So a trail that begins with an arrival leaves every set of crossings in
/// which it cannot go round: of the passes that lead out of the set, or would close a loop in it, one is
/// taken.
/// \param values  of every column of the formulation
/// \param price   what a pass counts beside its value: the higher, the fewer passes a row has, and the fewer
///                rows there are
/// \return rows that every graph obeys and these values break
[[nodiscard]] std::vector<Formulation::Row> brokenTrails(const PassGraph& graph, const ColumnValues& values,
                                                         double price);

} // namespace qm

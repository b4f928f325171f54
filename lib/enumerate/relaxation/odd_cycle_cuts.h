/// \file Odd cycle cuts: of an odd number of lines, each crossing the next and the last the first, fewer than
/// half can be passed at both crossings by one particle (docs/METHOD.md#odd-cycle-cuts).
#pragma once

#include "enumerate/relaxation/pass_graph.h"

#include <vector>

namespace qm {

/// \param values  of every column of the formulation
/// \return rows that every graph satisfies and these values violate
[[nodiscard]] std::vector<Formulation::Row> brokenOddCycles(const PassGraph& graph,
                                                            const ColumnValues& values);

} // namespace qm

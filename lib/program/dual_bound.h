/// \file What duals prove about the cost of a program, optimal or not: weak duality.
#pragma once

#include "program/integer_program.h"

namespace qm {

/// A lower bound of the cost of all solutions, also of those of the linear relaxation: what the duals pay for
/// the rows, and of every column that is cheaper with them than without, its reduced cost.
/// \param duals  of every row; where the side that one asks for is infinite, it counts as 0
[[nodiscard]] double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals);

} // namespace qm

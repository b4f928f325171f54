/// \file The lower bound that duals prove, whether optimal or not: weak duality.
#pragma once

#include "program/integer_program.h"

namespace qm {

/// Moves a row into the costs, weighted by its dual (Lagrangian relaxation).
/// \param dual  counts as 0 if the limit on its side is infinite: then its sign is noise of the solver
/// \return what is added to the constant
double moveIntoCosts(const IntegerProgram::Row& row, double dual, ColumnValues& costs);

/// A lower bound of the cost of all solutions, including those of the linear relaxation: the duals times the
/// limits of their rows, plus all negative reduced costs.
/// \param duals  of every row; a dual whose limit is infinite counts as 0
[[nodiscard]] double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals);

} // namespace qm

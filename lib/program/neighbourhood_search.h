/// \file Making a solution of an integer program better, a neighbourhood of columns at a time: large
/// neighbourhood search (docs/METHOD.md#shaw-1998).
#pragma once

#include "base/control.h"
#include "program/integer_program.h"

#include <vector>

namespace qm {

/// For programs that are too large to be solved at once. A neighbourhood holds the columns nearest to one
/// column, or to all columns of one group; two columns of one row are one step apart. All others keep their
/// values while it is solved.
/// Neighbourhoods grow when they no longer help, up to the whole program.
/// \param values   obey all rows; the result does too, and never costs more
/// \param groups   columns that tend to change together
/// \param seconds  after which the best so far is returned
[[nodiscard]] std::vector<double> improveByNeighbourhoods(const IntegerProgram& program,
                                                          std::vector<double> values,
                                                          const std::vector<std::vector<int>>& groups,
                                                          double seconds, const Control& control = {});

} // namespace qm

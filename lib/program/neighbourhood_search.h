/// \file Improving a solution of an integer program, one neighbourhood of columns at a time: large
/// neighbourhood search (docs/METHOD.md#shaw-1998).
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "program/integer_program.h"

#include <cstdint>
#include <vector>

namespace qm {

/// Without a limit of time, the result is the same on every machine.
struct NeighbourhoodOptions {
    double seconds = infinity; ///< in total; the best so far is returned
    std::size_t columns = 250; ///< of a neighbourhood at first
    std::uint32_t seed = 5489; ///< for the choice of neighbourhoods
};

/// For programs that are too large to be solved at once. A neighbourhood contains the columns nearest to one
/// column or to all columns of a group, where columns that share a row are one step apart. All other columns
/// keep their values while it is solved. When neighbourhoods no longer help, they grow, up to the whole
/// program.
/// \param values   must satisfy all rows; so does the result, whose cost is never higher
/// \param groups   columns that tend to change together
[[nodiscard]] ColumnValues improveByNeighbourhoods(const IntegerProgram& program, ColumnValues values,
                                                   const std::vector<std::vector<ColumnId>>& groups,
                                                   const NeighbourhoodOptions& options,
                                                   const Control& control = {});

} // namespace qm

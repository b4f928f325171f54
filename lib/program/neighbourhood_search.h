/// \file Making a solution of an integer program better, a neighbourhood of columns at a time: large
/// neighbourhood search (docs/METHOD.md#shaw-1998).
#pragma once

#include "base/control.h"
#include "program/integer_program.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace qm {

/// All limits but `seconds` count, so that without it the result is the same on every machine.
struct NeighbourhoodOptions {
    double seconds = std::numeric_limits<double>::infinity(); ///< in all; then the best so far is returned
    int nodes = 100;                                          ///< of branch and bound, for one neighbourhood
    std::size_t columns = 250;                                ///< of a neighbourhood at first
    std::size_t longRow = 40;  ///< a row of more columns makes no neighbours of them
    int patience = 12;         ///< neighbourhoods in vain before they grow
    std::uint32_t seed = 5489; ///< of the places where neighbourhoods lie
};

/// For programs that are too large to be solved at once. A neighbourhood holds the columns nearest to one
/// column, or to all columns of one group; two columns of one row are one step apart. All others keep their
/// values while it is solved.
/// Neighbourhoods grow when they no longer help, up to the whole program.
/// \param values   obey all rows; the result does too, and never costs more
/// \param groups   columns that tend to change together
[[nodiscard]] ColumnValues improveByNeighbourhoods(const IntegerProgram& program, ColumnValues values,
                                                   const std::vector<std::vector<ColumnId>>& groups,
                                                   const NeighbourhoodOptions& options,
                                                   const Control& control = {});

} // namespace qm

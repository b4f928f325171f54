/// \file Solving integer programs with CBC.
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "program/integer_program.h"

#include <limits>
#include <optional>

namespace qm {

struct ProgramSolution {
    std::optional<ColumnValues> values; ///< every column is 0 or 1; nothing if no solution was found
    double lowerBound = 0;              ///< of the cost
    bool proven = false;
};

struct ProgramLimits {
    double seconds = infinity;
    int nodes = std::numeric_limits<int>::max(); ///< limit of branch and bound
};

/// Minimises the cost. Stops at a limit, or soon after `control.stopRequested`, with the best solution so
/// far. Must not run on two threads at the same time: CBC keeps its parameters in globals.
/// \param start  values that satisfy all rows, to begin with; may be empty
[[nodiscard]] ProgramSolution solveProgram(const IntegerProgram& program, const ColumnValues& start,
                                           const ProgramLimits& limits, const Control& control = {});

/// A lower bound of the cost: the minimum itself if there is enough time, minus infinity if there is too
/// little. May be called on several threads at the same time.
/// \pre the program has a solution
[[nodiscard]] double boundProgram(const IntegerProgram& program, double seconds, const Control& control = {});

} // namespace qm

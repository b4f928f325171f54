/// \file Integer programs, solved by CBC.
#pragma once

#include "base/control.h"
#include "program/integer_program.h"

#include <limits>
#include <optional>

namespace qm {

struct ProgramSolution {
    std::optional<ColumnValues> values; ///< 0 or 1 of every column; none if nothing was found
    double lowerBound = 0;              ///< of the costs
    bool proven = false;
};

struct ProgramLimits {
    double seconds = std::numeric_limits<double>::infinity();
    int nodes = std::numeric_limits<int>::max(); ///< of branch and bound
};

/// Minimises the costs; stops at a limit with the best so far, or soon after `control.stopRequested`.
/// \param start  values to begin with that obey all rows; may be empty
[[nodiscard]] ProgramSolution solveProgram(const IntegerProgram& program, const ColumnValues& start,
                                           const ProgramLimits& limits, const Control& control = {});

/// A lower bound of the cost, which is the minimum itself if there is time enough; minus infinity if there
/// was none. May run on several threads.
/// \pre the program has a solution
[[nodiscard]] double boundProgram(const IntegerProgram& program, double seconds, const Control& control = {});

} // namespace qm

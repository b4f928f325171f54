/// \file A linear relaxation solved nearly, by a first-order method, where the simplex method would take too
/// long: what it takes is linear in the program (docs/METHOD.md#large-relaxations).
///
/// Primal-dual hybrid gradients with restarts, reflected and drawn back to the last of them
/// (docs/METHOD.md#applegate-2021, docs/METHOD.md#pock-2011, docs/METHOD.md#lu-2024).
#pragma once

#include "base/control.h"
#include "program/integer_program.h"

namespace qm {

struct GradientOptions {
    std::size_t iterations = 20000; ///< at most
    double tolerance = 1e-3;        ///< of the gap between both sides, relative to the bound
};

struct NearOptimum {
    ColumnValues values;           ///< the last ones, 0 to 1; rows may be broken a little
    IdVector<RowId, double> duals; ///< of every row, with the right sign; those of the best bound
    double lowerBound = 0;         ///< that the duals prove: no solution of the relaxation costs less
};

/// \return the best found when `control.stopRequested`. It does not depend on the number of threads.
[[nodiscard]] NearOptimum relaxByGradients(const IntegerProgram& program, const GradientOptions& options,
                                           const Control& control = {});

} // namespace qm

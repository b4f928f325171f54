/// \file The simplex method from a solution that is nearly optimal, such as one found by gradients
/// (docs/METHOD.md#particle-program).
#pragma once

#include "base/control.h"
#include "program/decomposition_bound.h"

#include <cstddef>
#include <vector>

class ClpSimplex;

namespace qm {

/// Makes a basis near the solution: columns that are neither 0 nor 1 are in it, and as many rows are tight,
/// those with the largest duals. From there it solves, at any rate until `control.stopRequested`.
/// \param solver  of the columns of `near`, in their order
/// \param rows    of every row of the solver: which of `near` it is
void solveFromNear(ClpSimplex& solver, const RelaxedProgram& near, const std::vector<std::size_t>& rows,
                   const Control& control);

} // namespace qm

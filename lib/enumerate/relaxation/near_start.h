/// \file The simplex method started from a nearly optimal solution, such as one found by gradients
/// (docs/METHOD.md#large-relaxations).
#pragma once

#include "program/decomposition_bound.h"

#include <cstddef>
#include <vector>

class ClpSimplex;

namespace qm {

/// Makes a basis near the solution: columns strictly between 0 and 1 are basic, and as many rows are tight,
/// those with the largest duals. Then solves from this basis.
/// \param solver  has the columns of `near`, in their order
/// \param rows    for every row of the solver, its number in `near`
void solveFromNear(ClpSimplex& solver, const RelaxedProgram& near, const std::vector<std::size_t>& rows);

} // namespace qm

/// \file A bound above the linear relaxation, from clusters of columns solved as integer programs.
///
/// Lagrangian relaxation (docs/METHOD.md#decomposition-bound; Geoffrion 1974, docs/METHOD.md#geoffrion-1974).
/// Rows between clusters are moved into the costs, weighted by their duals. What remains is one integer
/// program per cluster, whose optimum is at least the bound that its duals prove. The gain is the difference
/// between the two.
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "program/integer_program.h"

#include <limits>

namespace qm {

/// An integer program with an optimal, or nearly optimal, solution of its linear relaxation.
struct RelaxedProgram {
    IntegerProgram program;
    double constant = 0;           ///< added to the cost
    ColumnValues values;           ///< relaxed value of every column
    IdVector<RowId, double> duals; ///< of every row: how fast the relaxed optimum grows with its limits
    double cutoff = infinity;      ///< solutions of at least this cost do not matter
};

struct DecompositionOptions {
    std::size_t columns = 500; ///< of a cluster at first; doubled while there is time
    std::size_t maxColumns = std::numeric_limits<std::size_t>::max();
    double seconds = 0; ///< in total
};

/// \return a lower bound of the program's cost, at most the cutoff; minus infinity if there was too little
/// time. Unless time runs out, the result does not depend on `control.jobs`.
[[nodiscard]] double decompositionBound(const RelaxedProgram& relaxed, const DecompositionOptions& options,
                                        const Control& control = {});

} // namespace qm

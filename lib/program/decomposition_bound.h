/// \file A bound beyond the linear relaxation: clusters of columns are solved as integer programs.
///
/// Lagrangian relaxation (docs/METHOD.md#decomposition-bound; Geoffrion 1974, docs/METHOD.md#geoffrion-1974).
/// Rows between clusters are paid for by their duals instead of being obeyed; what remains falls apart, and
/// every cluster's optimum is at least what the duals prove of it. The gain is what fractional values
/// inside of clusters had saved.
#pragma once

#include "base/control.h"
#include "program/integer_program.h"

#include <limits>

namespace qm {

/// An integer program with an optimum of its linear relaxation, or what is near one.
struct RelaxedProgram {
    IntegerProgram program;
    double constant = 0;           ///< of the cost
    ColumnValues values;           ///< of every column
    IdVector<RowId, double> duals; ///< of every row: by how much the relaxed optimum grows with its bounds
    double cutoff =
        std::numeric_limits<double>::infinity(); ///< solutions of at least this cost do not matter
};

struct DecompositionOptions {
    std::size_t columns = 500; ///< of a cluster at first; they double while there is time
    std::size_t maxColumns = std::numeric_limits<std::size_t>::max();
    double seconds = 0; ///< in all
};

/// \return a bound of the program's cost, at most the cutoff; minus infinity if time was too short. Where
/// time does not end it, the result does not depend on `control.jobs`.
[[nodiscard]] double decompositionBound(const RelaxedProgram& relaxed, const DecompositionOptions& options,
                                        const Control& control = {});

} // namespace qm

/// \file A search problem as a mixed integer program over particles (docs/METHOD.md#particle-program).
///
/// A variable that two particles can reach is y = p + s, where p = 1 if the particle from before walks the
/// arc, and s = 1 if the one from after does. Rule 3: along a chain p never rises and s never falls. Rule 2:
/// a particle stops only where a particle passes on the other line, because a head-on meeting that nobody
/// passes can be moved to an end of its line without changing the graph. Rule 4 (as A2): of two crossing
/// lines at most one is passed. Every stop makes two corners of segments.
#pragma once

#include "base/sparse_id_vector.h"
#include "enumerate/state/search_state.h"
#include "program/integer_program.h"

#include <vector>

namespace qm {

/// Every row is an inequality or an equation over a few columns.
struct Formulation : IntegerProgram {
    /// The columns of a variable; none for a particle that cannot reach it, or if the variable is fixed.
    struct Columns {
        ColumnId fromBefore;
        ColumnId fromAfter;
        RowId cover; ///< the row p + s <= 1 if there are both
        [[nodiscard]] bool any() const { return fromBefore.valid() || fromAfter.valid(); }
    };
    /// Of variables of the part, and of lines that are covered but may be cracked.
    SparseIdVector<VariableId, Columns> columnsOf;
    IdVector<ColumnId, VariableId> variableOf; ///< none for a flag that a crossing has no arcs
    double constant = 0;                       ///< added to the cost of the columns
    /// Crossings where particles may pass and stop on both lines, and rules 2 and 4 hold as they are.
    std::vector<CrossingId> plainCrossings;
};

/// \param variables  free in the state; no rule ties them to a free variable that is not among them
[[nodiscard]] Formulation formulate(const SearchState& state, const std::vector<VariableId>& variables);

} // namespace qm

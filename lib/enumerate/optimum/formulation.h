/// \file A search problem as a mixed integer program over particles (docs/METHOD.md#particle-program).
///
/// A variable that two particles can reach is y = p + s: p the particle from before walks the arc, s the one
/// from after. Along a chain p falls and s rises, which is rule 3. A head-on meeting that nothing passes
/// through can be moved to an end of its line without changing the graph; so a particle stops at a junction
/// only where the other line is passed by one particle, and that is rule 2. Of two crossing lines at most one
/// is passed (A2), which is rule 4. Every stop brings two corners of segments.
#pragma once

#include "enumerate/state/search_state.h"
#include "program/integer_program.h"

#include <vector>

namespace qm {

/// All columns are binary. Every row is an inequality or equation of a few columns.
struct Formulation {
    /// Of a variable; none where a particle cannot reach it, or where nothing is left to say of it.
    struct Columns {
        ColumnId fromBefore;
        ColumnId fromAfter;
        [[nodiscard]] bool any() const { return fromBefore.valid() || fromAfter.valid(); }
    };
    using Row = IntegerProgram::Row;
    IdVector<VariableId, Columns> columnsOf;   ///< of every variable of the problem and both constants
    IdVector<VariableId, RowId> coverRowOf;    ///< row p + s <= 1, where a variable has both; else none
    IdVector<ColumnId, VariableId> variableOf; ///< none of a column that says that a junction is empty
    ColumnValues costs;                        ///< of every column
    double constant = 0;                       ///< of the cost
    IdVector<RowId, Row> rows;
    /// Where both lines may be passed and stopped at from both sides, by rules 2 and 4 as they stand.
    std::vector<CrossingId> plainCrossings;
};

/// \param variables  free in the state; everything that they have rules with is fixed or among them
[[nodiscard]] Formulation formulate(const SearchState& state, const std::vector<VariableId>& variables);

} // namespace qm

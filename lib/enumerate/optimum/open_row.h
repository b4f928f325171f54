/// \file What is left of a formulation's row where a state has fixed columns
/// (docs/METHOD.md#particle-program).
#pragma once

#include "enumerate/optimum/column_state.h"

#include <vector>

namespace qm {

/// A row without the columns that were fixed; its limits are those of the state, less `constant`.
struct OpenRow {
    RowId row;                ///< of the formulation
    std::vector<int> columns; ///< those that are open, by their number among these
    std::vector<double> weights;
    double constant = 0; ///< what the fixed columns add

    /// With the constant.
    /// \param values  of every open column
    [[nodiscard]] double sum(const double* values) const;
};

/// \param numberOf  of every column of the formulation: its number among the open ones
/// \return a row without columns if the row holds whatever these are
[[nodiscard]] OpenRow openRow(const Formulation& formulation, RowId id, const ColumnState& state,
                              const IdVector<ColumnId, int>& numberOf);

} // namespace qm

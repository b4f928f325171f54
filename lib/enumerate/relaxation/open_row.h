/// \file What remains of a row of a formulation when some of its columns are fixed
/// (docs/METHOD.md#particle-program).
#pragma once

#include "enumerate/relaxation/column_state.h"

#include <vector>

namespace qm {

/// A row without its fixed columns. Its limits are those of the row in the state, less `constant`.
struct OpenRow {
    RowId row;                ///< in the formulation
    std::vector<int> columns; ///< the open columns of the row, numbered among all open columns
    std::vector<double> weights;
    double constant = 0; ///< the contribution of the fixed columns

    /// The value of the row, including the constant.
    /// \param values  of all open columns
    [[nodiscard]] double sum(const double* values) const;
};

/// \param numberOf  for every column of the formulation, its number among the open ones
/// \return a row without columns if the row holds for all values of its open columns
[[nodiscard]] OpenRow openRow(const Formulation& formulation, RowId id, const ColumnState& state,
                              const IdVector<ColumnId, int>& numberOf);

} // namespace qm

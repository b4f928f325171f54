#include "enumerate/relaxation/open_row.h"

#include <algorithm>

namespace qm {

double OpenRow::sum(const double* values) const {
    double sum = constant;
    for (std::size_t k = 0; k < columns.size(); ++k)
        sum += weights[k] * values[columns[k]];
    return sum;
}

OpenRow openRow(const Formulation& formulation, RowId id, const ColumnState& state,
                const IdVector<ColumnId, int>& numberOf) {
    const Formulation::Row& row = formulation.rows[id];
    OpenRow open;
    open.row = id;
    double min = 0, max = 0;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const ArcState value = state.value(row.columns[k]);
        if (value == ArcState::in) open.constant += row.weights[k];
        if (value != ArcState::free) continue;
        open.columns.push_back(numberOf[row.columns[k]]);
        open.weights.push_back(row.weights[k]);
        min += std::min(row.weights[k], 0.0);
        max += std::max(row.weights[k], 0.0);
    }
    // The lower limit of a cover row may rise later; its upper limit can always be violated.
    if (min >= row.lower - open.constant && max <= row.upper - open.constant) return {};
    return open;
}

} // namespace qm

#include "program/dual_bound.h"

#include <algorithm>
#include <cmath>

namespace qm {

double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals) {
    double bound = 0;
    ColumnValues reduced = program.costs;
    for (const RowId id : program.rows.ids()) {
        const IntegerProgram::Row& row = program.rows[id];
        const double dual = duals[id], side = dual > 0 ? row.lower : row.upper;
        if (dual == 0 || std::isinf(side)) continue;
        bound += dual * side;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            reduced[row.columns[k]] -= dual * row.weights[k];
    }
    for (const double cost : reduced)
        bound += std::min(0.0, cost);
    return bound;
}

} // namespace qm

#include "program/dual_bound.h"

#include <algorithm>
#include <cmath>

namespace qm {

double moveIntoCosts(const IntegerProgram::Row& row, double dual, ColumnValues& costs) {
    const double side = dual > 0 ? row.lower : row.upper;
    if (dual == 0 || std::isinf(side)) return 0;
    for (std::size_t k = 0; k < row.columns.size(); ++k)
        costs[row.columns[k]] -= dual * row.weights[k];
    return dual * side;
}

double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals) {
    double bound = 0;
    ColumnValues reduced = program.costs;
    for (const RowId row : program.rows.ids())
        bound += moveIntoCosts(program.rows[row], duals[row], reduced);
    for (const double cost : reduced)
        bound += std::min(0.0, cost);
    return bound;
}

} // namespace qm

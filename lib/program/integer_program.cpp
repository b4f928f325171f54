#include "program/integer_program.h"

#include "base/at.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace qm {

void IntegerProgram::Row::add(ColumnId column, double weight) {
    const auto known = std::ranges::find(columns, column);
    if (known == columns.end()) {
        columns.push_back(column);
        weights.push_back(weight);
    } else {
        weights[at(known - columns.begin())] += weight;
    }
}

double IntegerProgram::Row::sum(const ColumnValues& values) const {
    double sum = 0;
    for (std::size_t k = 0; k < columns.size(); ++k)
        sum += weights[k] * values[columns[k]];
    return sum;
}

double IntegerProgram::cost(const ColumnValues& values) const {
    return std::inner_product(values.begin(), values.end(), costs.begin(), 0.0);
}

bool IntegerProgram::allows(const ColumnValues& values) const {
    constexpr double rounding = 1e-9;
    return std::ranges::all_of(rows, [&](const Row& row) {
        const double sum = row.sum(values);
        return row.lower - rounding <= sum && sum <= row.upper + rounding;
    });
}

IdVector<ColumnId, std::vector<RowId>> IntegerProgram::rowsOfColumns() const {
    IdVector<ColumnId, std::vector<RowId>> result(costs.size());
    for (const RowId row : rows.ids())
        for (const ColumnId column : rows[row].columns)
            result[column].push_back(row);
    return result;
}

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

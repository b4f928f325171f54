#include "program/integer_program.h"

#include "base/at.h"

#include <algorithm>
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

double IntegerProgram::cost(const ColumnValues& values) const {
    return std::inner_product(values.begin(), values.end(), costs.begin(), 0.0);
}

bool IntegerProgram::allows(const ColumnValues& values) const {
    constexpr double rounding = 1e-9;
    return std::ranges::all_of(rows, [&](const Row& row) {
        double sum = 0;
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            sum += row.weights[k] * values[row.columns[k]];
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

} // namespace qm

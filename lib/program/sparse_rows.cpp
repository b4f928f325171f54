#include "program/sparse_rows.h"

#include <cmath>
#include <utility>

namespace qm {

SparseRows::SparseRows(const IntegerProgram& program) {
    for (const IntegerProgram::Row& row : program.rows) {
        for (std::size_t k = 0; k < row.columns.size(); ++k)
            add(row.columns[k].idx(), row.weights[k]);
        endRow();
    }
}

double SparseRows::absoluteSum(std::size_t row) const {
    double sum = 0;
    for (std::uint32_t k = starts_[row]; k < starts_[row + 1]; ++k)
        sum += std::abs(static_cast<double>(weights_[k]));
    return sum;
}

SparseRows SparseRows::transposed(std::size_t columns) const {
    std::vector<std::vector<std::pair<std::size_t, float>>> entries(columns);
    for (std::size_t row = 0; row < size(); ++row)
        for (std::uint32_t k = starts_[row]; k < starts_[row + 1]; ++k)
            entries[columns_[k]].emplace_back(row, weights_[k]);
    SparseRows result;
    for (const auto& column : entries) {
        for (const auto& [row, weight] : column)
            result.add(row, static_cast<double>(weight));
        result.endRow();
    }
    return result;
}

} // namespace qm

/// \file A sparse matrix stored by rows, for methods that mainly multiply by it.
#pragma once

#include "program/integer_program.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace qm {

/// Compressed sparse rows. Indices and weights are short, so that less memory is read; weights are rounded to
/// single precision.
class SparseRows {
public:
    SparseRows() = default;
    /// The weights of a program's rows.
    explicit SparseRows(const IntegerProgram& program);

    /// Adds an entry to the last row.
    void add(std::size_t column, double weight) {
        columns_.push_back(static_cast<std::uint32_t>(column));
        weights_.push_back(static_cast<float>(weight));
    }
    /// Ends the last row; the next entry begins another one.
    void endRow() { starts_.push_back(static_cast<std::uint32_t>(columns_.size())); }

    /// The number of rows.
    [[nodiscard]] std::size_t size() const { return starts_.size() - 1; }

    /// The product of a row and a vector.
    /// \param values  of every column
    [[nodiscard]] double product(std::size_t row, const std::vector<double>& values) const {
        double sum = 0;
        for (std::uint32_t k = starts_[row]; k < starts_[row + 1]; ++k)
            sum += static_cast<double>(weights_[k]) * values[columns_[k]];
        return sum;
    }

    /// The sum of the absolute weights in a row.
    [[nodiscard]] double absoluteSum(std::size_t row) const;

    /// The transposed matrix.
    /// \param columns  the number of columns
    [[nodiscard]] SparseRows transposed(std::size_t columns) const;

private:
    std::vector<std::uint32_t> starts_{0}; ///< where each row begins, and the end
    std::vector<std::uint32_t> columns_;
    std::vector<float> weights_;
};

} // namespace qm

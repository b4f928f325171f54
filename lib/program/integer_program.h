/// \file Linear programs in binary variables.
#pragma once

#include "base/id_vector.h"

#include <vector>

namespace qm {

using ColumnId = Id<struct ColumnTag>;
using RowId = Id<struct RowTag>;
using ColumnValues = IdVector<ColumnId, double>;

struct IntegerProgram {
    /// lower <= weights . columns <= upper
    struct Row {
        std::vector<ColumnId> columns;
        std::vector<double> weights;
        double lower = 0;
        double upper = 0;

        /// Adds to the weight of a column.
        void add(ColumnId column, double weight);
    };
    ColumnValues costs; ///< of every column; columns are 0 or 1
    IdVector<RowId, Row> rows;

    /// \param values  of every column
    [[nodiscard]] double cost(const ColumnValues& values) const;
    /// Whether the values satisfy all rows, up to rounding.
    [[nodiscard]] bool allows(const ColumnValues& values) const;
    /// For every column, the rows that contain it.
    [[nodiscard]] IdVector<ColumnId, std::vector<RowId>> rowsOfColumns() const;
};

/// Relaxed values closer than this to 0 or 1 count as integral.
constexpr double integral = 1e-6;

[[nodiscard]] constexpr bool isFractional(double value) {
    return value > integral && value < 1 - integral;
}

} // namespace qm

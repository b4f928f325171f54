/// \file A linear program in binary variables.
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

        /// Weights of the same column add up.
        void add(ColumnId column, double weight);
    };
    ColumnValues costs; ///< of every column; all are 0 or 1
    IdVector<RowId, Row> rows;

    /// \param values  of every column
    [[nodiscard]] double cost(const ColumnValues& values) const;
    /// Whether they obey all rows, but for rounding.
    [[nodiscard]] bool allows(const ColumnValues& values) const;
};

/// A relaxed value closer to 0 or 1 than this is taken for it.
constexpr double integral = 1e-6;

[[nodiscard]] constexpr bool isFractional(double value) {
    return value > integral && value < 1 - integral;
}

} // namespace qm

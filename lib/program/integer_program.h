/// \file Linear programs in binary variables, and the bound that duals prove, whether optimal or not: weak
/// duality.
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
        /// The weighted sum of the columns.
        [[nodiscard]] double sum(const ColumnValues& values) const;
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

/// Moves a row into the costs, weighted by its dual (Lagrangian relaxation).
/// \param dual  counts as 0 if the limit on its side is infinite: then its sign is noise of the solver
/// \return what is added to the constant
double moveIntoCosts(const IntegerProgram::Row& row, double dual, ColumnValues& costs);

/// A lower bound of the cost of all solutions, including those of the linear relaxation: the duals times the
/// limits of their rows, plus all negative reduced costs.
/// \param duals  of every row; a dual whose limit is infinite counts as 0
[[nodiscard]] double dualBound(const IntegerProgram& program, const IdVector<RowId, double>& duals);

/// Relaxed values closer than this to 0 or 1 count as integral.
constexpr double integral = 1e-6;

[[nodiscard]] constexpr bool isFractional(double value) {
    return value > integral && value < 1 - integral;
}

} // namespace qm

/// \file All rows of a relaxation, of which the solver has only those that matter
/// (docs/METHOD.md#particle-program).
///
/// Most rows never bind. The solver gets a row when a solution violates it, and may lose it again when it
/// does not bind.
#pragma once

#include "enumerate/relaxation/column_state.h"

#include <vector>

class ClpSimplex;

namespace qm {

/// A row without its fixed columns. Its limits are those of the row in the state, less `constant`.
struct OpenRow {
    RowId row;                ///< in the formulation
    std::vector<int> columns; ///< the open columns of the row, numbered among all open columns
    std::vector<double> weights;
    double constant = 0; ///< the contribution of the fixed columns

    /// The value of the row, including the constant.
    /// \param values  of all open columns
    [[nodiscard]] double sum(const double* values) const;
};

/// \param numberOf  for every column of the formulation, its number among the open ones
/// \return a row without columns if the row holds for all values of its open columns
[[nodiscard]] OpenRow openRow(const Formulation& formulation, RowId id, const ColumnState& state,
                              const IdVector<ColumnId, int>& numberOf);

class RowPool {
public:
    /// \param formulation  must outlive this; `takeUp` reads its rows
    explicit RowPool(const Formulation& formulation) : formulation_(&formulation) {}

    /// Adds the rows that the formulation got since the last call, except rows that hold for all values of
    /// their open columns or have only one.
    /// \param numberOf  for every open column of the formulation, its number in the solver
    void takeUp(const ColumnState& state, const IdVector<ColumnId, int>& numberOf);

    /// All rows that may matter, in the solver or not.
    [[nodiscard]] const std::vector<OpenRow>& rows() const { return rows_; }
    /// For every row of the solver, its number in `rows`.
    [[nodiscard]] const std::vector<std::size_t>& inSolver() const { return inSolver_; }

    /// Gives the solver its first rows: those with two columns, or all rows if there are none of these.
    void giveFirst(ClpSimplex& solver, const ColumnState& state);
    /// Gives the solver the rows that its solution violates.
    /// \return whether there are any
    bool giveBroken(ClpSimplex& solver, const ColumnState& state);
    /// Gives the solver the rows with a large dual.
    /// \param duals  of all rows
    void giveTight(ClpSimplex& solver, const ColumnState& state, const IdVector<RowId, double>& duals);
    /// Takes rows that do not bind from the solver, except rows with two columns.
    void takeIdle(ClpSimplex& solver);

    /// Sets the lower limits of the solver's cover rows to those of the state.
    void setSides(ClpSimplex& solver, const ColumnState& state) const;
    /// The solver's duals of all rows; 0 for rows that the solver does not have.
    [[nodiscard]] std::vector<double> duals(const ClpSimplex& solver) const;

private:
    template <class Condition>
    bool giveWhere(ClpSimplex& solver, const ColumnState& state, const Condition& holds);

    const Formulation* formulation_;
    RowId next_{0}; ///< the formulation's first row that has not been read
    std::vector<OpenRow> rows_;
    std::vector<std::size_t> inSolver_;
    std::vector<bool> isInSolver_; ///< for every row of `rows_`
};

} // namespace qm

/// \file The rows of a relaxation, of which the solver has only those that matter
/// (docs/METHOD.md#particle-program).
///
/// Most rows never bind. The solver gets a row when a solution breaks it, and may lose it again when it does
/// not bind.
#pragma once

#include "enumerate/optimum/open_row.h"

#include <vector>

class ClpSimplex;

namespace qm {

class RowPool {
public:
    /// \param formulation  outlives this; its rows are taken up by `takeUp`
    explicit RowPool(const Formulation& formulation) : formulation_(&formulation) {}

    /// Takes up the rows that the formulation has got since the last time, but for those that hold whatever
    /// the open columns are, or have one open column only.
    /// \param numberOf  of every column of the formulation: its number in the solver, if it is open
    void takeUp(const ColumnState& state, const IdVector<ColumnId, int>& numberOf);

    /// All rows that may matter, whether the solver has them or not.
    [[nodiscard]] const std::vector<OpenRow>& rows() const { return rows_; }
    /// Of every row of the solver: its number in `rows`.
    [[nodiscard]] const std::vector<std::size_t>& inSolver() const { return inSolver_; }

    /// Gives the solver rows to begin with: those that tie two columns, or all, if there are none of them.
    void giveFirst(ClpSimplex& solver, const ColumnState& state);
    /// Gives it the rows that its solution breaks.
    /// \return whether there are any
    bool giveBroken(ClpSimplex& solver, const ColumnState& state);
    /// Gives it the rows whose dual is not small.
    /// \param duals  of all rows
    void giveTight(ClpSimplex& solver, const ColumnState& state, const IdVector<RowId, double>& duals);
    /// Takes those that do not bind from it, but for rows of two columns.
    void takeIdle(ClpSimplex& solver);

    /// Lets the lower sides of its rows be what they are in the state.
    void setSides(ClpSimplex& solver, const ColumnState& state) const;
    /// The solver's duals of all rows; 0 where it does not have the row.
    [[nodiscard]] std::vector<double> duals(const ClpSimplex& solver) const;

private:
    void give(ClpSimplex& solver, const std::vector<std::size_t>& rows, const ColumnState& state);

    const Formulation* formulation_;
    RowId next_{0}; ///< the first of the formulation that is not taken up
    std::vector<OpenRow> rows_;
    std::vector<std::size_t> inSolver_;
    std::vector<bool> isInSolver_; ///< of every one of `rows_`
};

} // namespace qm

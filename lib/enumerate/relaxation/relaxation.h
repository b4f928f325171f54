/// \file The linear relaxation of a formulation: its bound prunes, its solution guides
/// (docs/METHOD.md#particle-program).
///
/// Rows that tie two particles of one line are there from the start, the others as soon as a solution breaks
/// them: most never do.
#pragma once

#include "base/control.h"
#include "base/infinity.h"
#include "enumerate/relaxation/row_pool.h"
#include "program/decomposition_bound.h"

#include <memory>
#include <vector>

class ClpSimplex;

namespace qm {

class Relaxation {
public:
    /// Columns that the state has fixed and rows that these satisfy are left out for good.
    /// \param control  whose `stopRequested` leaves every solution unfinished
    Relaxation(const Formulation& formulation, const ColumnState& state, const Control& control);
    ~Relaxation();
    Relaxation(Relaxation&&) noexcept;
    Relaxation& operator=(Relaxation&&) noexcept;
    Relaxation(const Relaxation&) = delete;
    Relaxation& operator=(const Relaxation&) = delete;

    struct Result {
        enum class Kind { solved, tooExpensive, unfinished };
        Kind kind = Kind::unfinished;
        double bound = 0;          ///< only an estimate if unfinished
        double proven = -infinity; ///< a bound all the same, if unfinished
    };

    /// Minimises the relaxed cost under what the state has fixed. Too expensive: infeasible, or at least
    /// `cutoff`. Unfinished: the iterations were used up, the solver was stopped, or it failed.
    Result solve(const ColumnState& state, double cutoff, int iterations);

    /// The work of all solutions so far, to which their time is about proportional: the sum, over the
    /// iterations, of the solver's rows and columns. Unlike the time, it is the same on every machine.
    [[nodiscard]] std::size_t work() const { return work_; }

    /// Takes over a solution that is nearly optimal, with the rows that are tight there.
    /// \param near  the program of a relaxation that has not been solved yet, see `program`
    void takeNear(const RelaxedProgram& near, const ColumnState& state);
    /// Begins at the solution taken over, from which the simplex method is soon done.
    void startNear(const RelaxedProgram& near);

    /// Takes up the rows that the formulation has got since.
    void addRows(const ColumnState& state);
    /// Takes those that do not bind from the solver; they come back when a solution breaks them.
    void dropIdleRows();

    /// The share of the solver's columns that the state has fixed, 0 to 1.
    [[nodiscard]] double fixedShare(const ColumnState& state) const;

    /// Where the solver stands, to return to after probing.
    using Basis = std::vector<unsigned char>;
    [[nodiscard]] Basis basis() const;
    void setBasis(const Basis& basis);

    /// The integer program of what the state leaves open, with the last solution, which was of the same
    /// state. All values and duals are 0 before the first one.
    [[nodiscard]] RelaxedProgram program(const ColumnState& state) const;

    /// The value of every column in the last solution; 0 or 1 where it was fixed.
    [[nodiscard]] const ColumnValues& values() const { return values_; }
    /// By how much per unit the bound grows at least when a column leaves its value in the last solution.
    [[nodiscard]] const ColumnValues& reducedCosts() const { return reducedCosts_; }

private:
    Result solveWithoutRows(const ColumnState& state, double cutoff);
    void setBounds(const ColumnState& state);
    void read(const ColumnState& state);

    const Formulation* formulation_;
    std::vector<ColumnId> columns_; ///< of the formulation, for every column of the solver
    RowPool rows_;
    std::unique_ptr<ClpSimplex> solver_;
    std::size_t work_ = 0;
    double fixedCost_ = 0; ///< of the columns that were left out
    ColumnValues values_;
    ColumnValues reducedCosts_;
};

} // namespace qm

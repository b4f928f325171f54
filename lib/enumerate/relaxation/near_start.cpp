#include "enumerate/relaxation/near_start.h"

#include "base/at.h"

#include <coin/ClpSimplex.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace qm {
namespace {

/// Columns whose values are farther than this from 0 and 1 become basic.
constexpr double fractional = 0.02;

/// Clp's value for "none". Perturbed costs would lead away from a solution that is nearly optimal.
constexpr int noPerturbation = 100;

/// Sets the values and the status of all columns.
/// \return the number of basic columns
std::size_t setColumns(ClpSimplex& solver, const ColumnValues& values) {
    std::size_t basics = 0;
    for (const ColumnId column : values.ids()) {
        const double value = values[column];
        const bool basic = value > fractional && value < 1 - fractional;
        const int k = static_cast<int>(column.idx());
        solver.setColumnStatus(k, basic         ? ClpSimplex::basic
                                  : value < 0.5 ? ClpSimplex::atLowerBound
                                                : ClpSimplex::atUpperBound);
        solver.primalColumnSolution()[k] = value;
        if (basic) ++basics;
    }
    return basics;
}

/// Makes the `count` rows with the largest duals tight, and all others basic.
void setTightRows(ClpSimplex& solver, const IdVector<RowId, double>& duals,
                  const std::vector<std::size_t>& rows, std::size_t count) {
    std::vector<std::pair<double, int>> order;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const double dual = duals[RowId(rows[k])];
        if (dual != 0) order.emplace_back(-std::abs(dual), static_cast<int>(k));
        solver.setRowStatus(static_cast<int>(k), ClpSimplex::basic);
    }
    std::ranges::sort(order);
    order.resize(std::min(order.size(), count));
    for (const auto& [negative, k] : order)
        solver.setRowStatus(k, duals[RowId(rows[at(k)])] > 0 ? ClpSimplex::atLowerBound
                                                             : ClpSimplex::atUpperBound);
}

} // namespace

void solveFromNear(ClpSimplex& solver, const RelaxedProgram& near, const std::vector<std::size_t>& rows) {
    solver.createStatus();
    setTightRows(solver, near.duals, rows, setColumns(solver, near.values));
    const int perturbation = solver.perturbation();
    solver.setPerturbation(noPerturbation);
    solver.setMaximumIterations(std::numeric_limits<int>::max());
    solver.primal();
    solver.setPerturbation(perturbation);
}

} // namespace qm

#include "enumerate/relaxation/row_pool.h"

#include "program/coin.h"

#include <coin/ClpSimplex.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

/// A row counts as violated from this excess on.
constexpr double broken = 1e-6;

/// Smallest dual of rows that are given to the solver at once: it is slow with many, and few of them bind.
constexpr double minDual = 1e-3;

} // namespace

double OpenRow::sum(const double* values) const {
    double sum = constant;
    for (std::size_t k = 0; k < columns.size(); ++k)
        sum += weights[k] * values[columns[k]];
    return sum;
}

OpenRow openRow(const Formulation& formulation, RowId id, const ColumnState& state,
                const IdVector<ColumnId, int>& numberOf) {
    const Formulation::Row& row = formulation.rows[id];
    OpenRow open;
    open.row = id;
    double min = 0, max = 0;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const ArcState value = state.value(row.columns[k]);
        if (value == ArcState::in) open.constant += row.weights[k];
        if (value != ArcState::free) continue;
        open.columns.push_back(numberOf[row.columns[k]]);
        open.weights.push_back(row.weights[k]);
        min += std::min(row.weights[k], 0.0);
        max += std::max(row.weights[k], 0.0);
    }
    // The lower limit of a cover row may rise later; its upper limit can always be violated.
    if (min >= row.lower - open.constant && max <= row.upper - open.constant) return {};
    return open;
}

void RowPool::takeUp(const ColumnState& state, const IdVector<ColumnId, int>& numberOf) {
    for (; next_ < formulation_->rows.nextId(); next_ = next_ + 1)
        if (OpenRow row = openRow(*formulation_, next_, state, numberOf); row.columns.size() > 1)
            rows_.push_back(std::move(row));
    isInSolver_.resize(rows_.size(), false);
}

/// Gives the solver the rows that it does not have and for which a condition holds.
/// \param holds  gets the number of a row
/// \return whether there are any
template <class Condition>
bool RowPool::giveWhere(ClpSimplex& solver, const ColumnState& state, const Condition& holds) {
    std::vector<CoinBigIndex> starts{0};
    std::vector<int> columns;
    std::vector<double> weights, lower, upper;
    for (std::size_t id = 0; id < rows_.size(); ++id) {
        if (isInSolver_[id] || !holds(id)) continue;
        const OpenRow& row = rows_[id];
        columns.insert(columns.end(), row.columns.begin(), row.columns.end());
        weights.insert(weights.end(), row.weights.begin(), row.weights.end());
        starts.push_back(static_cast<CoinBigIndex>(columns.size()));
        lower.push_back(coinBound(state.rowLower(row.row) - row.constant));
        upper.push_back(coinBound(formulation_->rows[row.row].upper - row.constant));
        inSolver_.push_back(id);
        isInSolver_[id] = true;
    }
    if (lower.empty()) return false;
    solver.addRows(static_cast<int>(lower.size()), lower.data(), upper.data(), starts.data(), columns.data(),
                   weights.data());
    return true;
}

void RowPool::giveFirst(ClpSimplex& solver, const ColumnState& state) {
    if (!giveWhere(solver, state, [&](std::size_t id) { return rows_[id].columns.size() == 2; }))
        giveWhere(solver, state, [](std::size_t) { return true; }); // the solver needs at least one row
}

bool RowPool::giveBroken(ClpSimplex& solver, const ColumnState& state) {
    const double* values = solver.primalColumnSolution();
    return giveWhere(solver, state, [&](std::size_t id) {
        const OpenRow& row = rows_[id];
        const double sum = row.sum(values);
        return sum < state.rowLower(row.row) - broken || sum > formulation_->rows[row.row].upper + broken;
    });
}

void RowPool::giveTight(ClpSimplex& solver, const ColumnState& state, const IdVector<RowId, double>& duals) {
    giveWhere(solver, state, [&](std::size_t id) { return std::abs(duals[RowId(id)]) > minDual; });
}

void RowPool::takeIdle(ClpSimplex& solver) {
    std::vector<int> idle;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < inSolver_.size(); ++k) {
        const std::size_t id = inSolver_[k];
        const bool isIdle =
            rows_[id].columns.size() > 2 && solver.getRowStatus(static_cast<int>(k)) == ClpSimplex::basic;
        if (isIdle) {
            idle.push_back(static_cast<int>(k));
            isInSolver_[id] = false;
        } else {
            kept.push_back(id);
        }
    }
    solver.deleteRows(static_cast<int>(idle.size()), idle.data());
    inSolver_ = std::move(kept);
}

void RowPool::setSides(ClpSimplex& solver, const ColumnState& state) const {
    for (std::size_t k = 0; k < inSolver_.size(); ++k) {
        const OpenRow& row = rows_[inSolver_[k]];
        if (std::isfinite(formulation_->rows[row.row].lower)) continue; // not a cover row
        const double lower = coinBound(state.rowLower(row.row) - row.constant);
        if (solver.rowLower()[k] != lower)
            solver.setRowBounds(static_cast<int>(k), lower, solver.rowUpper()[k]);
    }
}

std::vector<double> RowPool::duals(const ClpSimplex& solver) const {
    std::vector<double> duals(rows_.size(), 0);
    for (std::size_t k = 0; k < inSolver_.size(); ++k)
        duals[inSolver_[k]] = solver.dualRowSolution()[k];
    return duals;
}

} // namespace qm

#include "enumerate/optimum/relaxation.h"

#include "base/at.h"
#include "enumerate/optimum/near_start.h"

#include <coin/ClpSimplex.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace qm {
namespace {

double bounded(double value) {
    return std::isinf(value) ? std::copysign(COIN_DBL_MAX, value) : value;
}

constexpr double broken = 1e-6; ///< a row is violated by more than this

/// Of rows that a start from afar takes in at once: the solver is slow with many, and few of them bind.
constexpr double minDual = 1e-3;

} // namespace

Relaxation::Relaxation(const Formulation& formulation, const ColumnState& state)
    : formulation_(&formulation), solver_(std::make_unique<ClpSimplex>()),
      values_(formulation.costs.size(), 0), reducedCosts_(formulation.costs.size(), 0) {
    fixedCost_ = formulation.constant;
    for (const ColumnId column : formulation.costs.ids()) {
        if (state.value(column) == ArcState::in) fixedCost_ += formulation.costs[column];
        if (state.value(column) == ArcState::free) columns_.push_back(column);
    }
    addRows(state);
    solver_->setLogLevel(0);
    solver_->scaling(0);
    solver_->resize(0, static_cast<int>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        solver_->setColumnBounds(static_cast<int>(k), 0, 1);
        solver_->setObjectiveCoefficient(static_cast<int>(k), formulation.costs[columns_[k]]);
    }
    std::vector<const OpenRow*> first;
    for (const OpenRow& row : rows_)
        if (row.columns.size() == 2) first.push_back(&row);
    if (first.empty()) // the solver does not like to have none
        for (const OpenRow& row : rows_)
            first.push_back(&row);
    if (!first.empty()) add(first, state);
}

void Relaxation::addRows(const ColumnState& state) {
    IdVector<ColumnId, int> indexOf(formulation_->costs.size(), -1);
    for (std::size_t k = 0; k < columns_.size(); ++k)
        indexOf[columns_[k]] = static_cast<int>(k);
    for (; nextRow_ < formulation_->rows.nextId(); nextRow_ = nextRow_ + 1)
        if (OpenRow row = openRow(*formulation_, nextRow_, state, indexOf); row.columns.size() > 1)
            rows_.push_back(std::move(row));
    isInSolver_.resize(rows_.size(), false);
}

void Relaxation::dropIdleRows() {
    std::vector<int> idle;
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < solverRows_.size(); ++k) {
        const std::size_t id = solverRows_[k];
        const bool isIdle =
            rows_[id].columns.size() > 2 && solver_->getRowStatus(static_cast<int>(k)) == ClpSimplex::basic;
        if (isIdle) {
            idle.push_back(static_cast<int>(k));
            isInSolver_[id] = false;
        } else {
            kept.push_back(id);
        }
    }
    solver_->deleteRows(static_cast<int>(idle.size()), idle.data());
    solverRows_ = std::move(kept);
}

void Relaxation::add(const std::vector<const OpenRow*>& rows, const ColumnState& state) {
    std::vector<CoinBigIndex> starts{0};
    std::vector<int> columns;
    std::vector<double> weights, lower, upper;
    for (const OpenRow* row : rows) {
        columns.insert(columns.end(), row->columns.begin(), row->columns.end());
        weights.insert(weights.end(), row->weights.begin(), row->weights.end());
        starts.push_back(static_cast<CoinBigIndex>(columns.size()));
        lower.push_back(bounded(state.rowLower(row->row) - row->constant));
        upper.push_back(bounded(formulation_->rows[row->row].upper - row->constant));
        solverRows_.push_back(static_cast<std::size_t>(row - rows_.data()));
        isInSolver_[solverRows_.back()] = true;
    }
    solver_->addRows(static_cast<int>(rows.size()), lower.data(), upper.data(), starts.data(), columns.data(),
                     weights.data());
}

/// \return whether the solution breaks rows that the solver did not know
bool Relaxation::addBroken(const ColumnState& state) {
    const double* values = solver_->primalColumnSolution();
    std::vector<const OpenRow*> rows;
    for (std::size_t id = 0; id < rows_.size(); ++id) {
        if (isInSolver_[id]) continue;
        const OpenRow& row = rows_[id];
        const double sum = row.sum(values);
        if (sum < state.rowLower(row.row) - broken || sum > formulation_->rows[row.row].upper + broken)
            rows.push_back(&row);
    }
    if (!rows.empty()) add(rows, state);
    return !rows.empty();
}

Relaxation::~Relaxation() = default;
Relaxation::Relaxation(Relaxation&&) noexcept = default;
Relaxation& Relaxation::operator=(Relaxation&&) noexcept = default;

void Relaxation::setBounds(const ColumnState& state) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const ArcState value = state.value(columns_[k]);
        const double lower = value == ArcState::in ? 1 : 0, upper = value == ArcState::out ? 0 : 1;
        if (solver_->columnLower()[k] != lower || solver_->columnUpper()[k] != upper)
            solver_->setColumnBounds(static_cast<int>(k), lower, upper);
    }
    for (std::size_t k = 0; k < solverRows_.size(); ++k) {
        const OpenRow& row = rows_[solverRows_[k]];
        if (std::isfinite(formulation_->rows[row.row].lower)) continue; // not a cover row
        const double lower = bounded(state.rowLower(row.row) - row.constant);
        if (solver_->rowLower()[k] != lower)
            solver_->setRowBounds(static_cast<int>(k), lower, solver_->rowUpper()[k]);
    }
}

void Relaxation::read(const ColumnState& state) {
    for (const ColumnId column : values_.ids()) {
        values_[column] = state.value(column) == ArcState::in ? 1 : 0;
        reducedCosts_[column] = 0;
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        values_[columns_[k]] = solver_->primalColumnSolution()[k];
        reducedCosts_[columns_[k]] = solver_->dualColumnSolution()[k];
    }
}

/// Minimises column by column; the solver cannot be relied on for problems without rows.
Relaxation::Result Relaxation::solveWithoutRows(const ColumnState& state, double cutoff) {
    Result result{Result::Kind::solved, formulation_->constant};
    for (const ColumnId column : values_.ids()) {
        const ArcState known = state.value(column);
        const double cost = formulation_->costs[column];
        const bool in = known == ArcState::in || (known == ArcState::free && cost < 0);
        values_[column] = in ? 1 : 0;
        reducedCosts_[column] = cost;
        result.bound += in ? cost : 0;
    }
    if (result.bound >= cutoff) result.kind = Result::Kind::tooExpensive;
    return result;
}

Relaxation::Result Relaxation::solve(const ColumnState& state, double cutoff, int iterations) {
    if (rows_.empty()) return solveWithoutRows(state, cutoff);
    setBounds(state);
    solver_->setDualObjectiveLimit(std::isinf(cutoff) ? COIN_DBL_MAX : cutoff - fixedCost_);
    Result result;
    for (;;) {
        solver_->setMaximumIterations(iterations);
        solver_->dual();
        if (solver_->status() > 3) solver_->primal();
        iterations -= solver_->numberIterations();
        if (solver_->status() == 1) return {Result::Kind::tooExpensive};
        result.bound = solver_->objectiveValue() + fixedCost_;
        if (solver_->status() != 0) return result;
        if (result.bound >= cutoff) return {Result::Kind::tooExpensive, result.bound};
        result.proven = result.bound; // the rows that are missing can only raise it
        if (!addBroken(state)) break;
        if (iterations <= 0) return result;
    }
    result.kind = Result::Kind::solved;
    read(state);
    return result;
}

RelaxedProgram Relaxation::program(const ColumnState& state) const {
    RelaxedProgram relaxed;
    relaxed.constant = fixedCost_;
    std::vector<ColumnId> indexOf(columns_.size());
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const ArcState value = state.value(columns_[k]);
        const double cost = formulation_->costs[columns_[k]];
        if (value == ArcState::in) relaxed.constant += cost;
        if (value != ArcState::free) continue;
        indexOf[k] = relaxed.values.nextId();
        relaxed.values.push_back(values_[columns_[k]]);
        relaxed.program.costs.push_back(cost);
    }
    std::vector<double> duals(rows_.size(), 0);
    for (std::size_t k = 0; k < solverRows_.size(); ++k)
        duals[solverRows_[k]] = solver_->dualRowSolution()[k];
    for (std::size_t id = 0; id < rows_.size(); ++id) {
        const OpenRow& row = rows_[id];
        double constant = row.constant;
        IntegerProgram::Row open;
        for (std::size_t k = 0; k < row.columns.size(); ++k) {
            const std::size_t column = at(row.columns[k]);
            if (state.value(columns_[column]) == ArcState::in) constant += row.weights[k];
            if (!indexOf[column].valid()) continue;
            open.columns.push_back(indexOf[column]);
            open.weights.push_back(row.weights[k]);
        }
        if (open.columns.empty()) continue;
        open.lower = state.rowLower(row.row) - constant;
        open.upper = formulation_->rows[row.row].upper - constant;
        relaxed.program.rows.push_back(std::move(open));
        relaxed.duals.push_back(duals[id]);
    }
    return relaxed;
}

void Relaxation::startNear(const RelaxedProgram& near, const ColumnState& state, const Control& control) {
    std::vector<const OpenRow*> tight;
    for (std::size_t id = 0; id < rows_.size(); ++id)
        if (!isInSolver_[id] && std::abs(near.duals[RowId(id)]) > minDual) tight.push_back(&rows_[id]);
    if (!tight.empty()) add(tight, state);
    read(state);
    for (const ColumnId column : near.values.ids())
        values_[columns_[column.idx()]] = near.values[column];
    solveFromNear(*solver_, near, solverRows_, control);
}

double Relaxation::fixedShare(const ColumnState& state) const {
    const auto fixed = std::ranges::count_if(
        columns_, [&](ColumnId column) { return state.value(column) != ArcState::free; });
    return columns_.empty() ? 0 : static_cast<double>(fixed) / static_cast<double>(columns_.size());
}

Relaxation::Basis Relaxation::basis() const {
    if (!solver_->statusExists()) return {};
    const unsigned char* status = solver_->statusArray();
    return {status, status + columns_.size() + solverRows_.size()};
}

void Relaxation::setBasis(const Basis& basis) {
    if (basis.empty()) return;
    Basis extended = basis; // rows that came later are not tight
    extended.resize(columns_.size() + solverRows_.size(), ClpSimplex::basic);
    solver_->copyinStatus(extended.data());
}

} // namespace qm

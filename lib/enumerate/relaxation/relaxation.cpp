#include "enumerate/relaxation/relaxation.h"

#include "base/at.h"
#include "enumerate/relaxation/near_start.h"
#include "program/coin.h"

#include <coin/ClpSimplex.hpp>

#include <algorithm>
#include <utility>

namespace qm {

Relaxation::Relaxation(const Formulation& formulation, const ColumnState& state, const Control& control)
    : formulation_(&formulation), rows_(formulation), solver_(std::make_unique<ClpSimplex>()),
      values_(formulation.costs.size(), 0), reducedCosts_(formulation.costs.size(), 0) {
    fixedCost_ = formulation.constant;
    for (const ColumnId column : formulation.costs.ids()) {
        if (state.value(column) == ArcState::in) fixedCost_ += formulation.costs[column];
        if (state.value(column) == ArcState::free) columns_.push_back(column);
    }
    addRows(state);
    StopOnRequest handler(control);
    solver_->passInEventHandler(&handler);
    solver_->setLogLevel(0);
    solver_->scaling(0);
    solver_->resize(0, static_cast<int>(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        solver_->setColumnBounds(static_cast<int>(k), 0, 1);
        solver_->setObjectiveCoefficient(static_cast<int>(k), formulation.costs[columns_[k]]);
    }
    rows_.giveFirst(*solver_, state);
}

void Relaxation::addRows(const ColumnState& state) {
    IdVector<ColumnId, int> indexOf(formulation_->costs.size(), -1);
    for (std::size_t k = 0; k < columns_.size(); ++k)
        indexOf[columns_[k]] = static_cast<int>(k);
    rows_.takeUp(state, indexOf);
}

void Relaxation::dropIdleRows() {
    rows_.takeIdle(*solver_);
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
    rows_.setSides(*solver_, state);
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
    if (rows_.rows().empty()) return solveWithoutRows(state, cutoff);
    setBounds(state);
    solver_->setDualObjectiveLimit(coinBound(cutoff - fixedCost_));
    constexpr int failed = 4; // a status of Clp
    Result result;
    for (;;) {
        solver_->setMaximumIterations(iterations);
        solver_->dual();
        if (solver_->status() == failed) solver_->primal();
        iterations -= solver_->numberIterations();
        work_ += at(solver_->numberIterations()) * at(solver_->numberRows() + solver_->numberColumns());
        if (solver_->status() == 1) return {Result::Kind::tooExpensive};
        result.bound = solver_->objectiveValue() + fixedCost_;
        if (solver_->status() != 0) return result;
        if (result.bound >= cutoff) return {Result::Kind::tooExpensive, result.bound};
        result.proven = result.bound; // the rows that are missing can only raise it
        if (!rows_.giveBroken(*solver_, state)) break;
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
    const std::vector<double> duals = rows_.duals(*solver_);
    for (std::size_t id = 0; id < rows_.rows().size(); ++id) {
        const OpenRow& row = rows_.rows()[id];
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

void Relaxation::takeNear(const RelaxedProgram& near, const ColumnState& state) {
    rows_.giveTight(*solver_, state, near.duals);
    read(state);
    for (const ColumnId column : near.values.ids())
        values_[columns_[column.idx()]] = near.values[column];
}

void Relaxation::startNear(const RelaxedProgram& near) {
    solveFromNear(*solver_, near, rows_.inSolver());
}

double Relaxation::fixedShare(const ColumnState& state) const {
    const auto fixed = std::ranges::count_if(
        columns_, [&](ColumnId column) { return state.value(column) != ArcState::free; });
    return columns_.empty() ? 0 : static_cast<double>(fixed) / static_cast<double>(columns_.size());
}

Relaxation::Basis Relaxation::basis() const {
    if (!solver_->statusExists()) return {};
    const unsigned char* status = solver_->statusArray();
    return {status, status + columns_.size() + rows_.inSolver().size()};
}

void Relaxation::setBasis(const Basis& basis) {
    if (basis.empty()) return;
    Basis extended = basis; // rows that came later are not tight
    extended.resize(columns_.size() + rows_.inSolver().size(), ClpSimplex::basic);
    solver_->copyinStatus(extended.data());
}

} // namespace qm

#include "enumerate/relaxation.h"

#include <coin/ClpSimplex.hpp>
#include <coin/CoinPackedMatrix.hpp>

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

double bounded(double value) {
    return std::isinf(value) ? std::copysign(COIN_DBL_MAX, value) : value;
}

/// Rows for the solver, without what is fixed.
struct Rows {
    std::vector<int> rowOf; ///< of every non-zero
    std::vector<int> columnOf;
    std::vector<double> weights;
    std::vector<double> lower;
    std::vector<double> upper;
};

/// The part of a row that is still open.
struct OpenRow {
    std::vector<std::size_t> terms;
    double constant = 0;
    double least = 0;
    double most = 0;
};

OpenRow openPart(const Formulation::Row& row, const ParticleState& state) {
    OpenRow open;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const ArcState value = state.column(row.columns[k]);
        if (value == ArcState::in) open.constant += row.weights[k];
        if (value != ArcState::free) continue;
        open.terms.push_back(k);
        open.least += std::min(row.weights[k], 0.0);
        open.most += std::max(row.weights[k], 0.0);
    }
    return open;
}

} // namespace

Relaxation::Relaxation(const Formulation& formulation, const ParticleState& state)
    : formulation_(&formulation), solver_(std::make_unique<ClpSimplex>()),
      values_(formulation.costs.size(), 0), reducedCosts_(formulation.costs.size(), 0) {
    std::vector<int> indexOf(formulation.costs.size(), -1);
    std::vector<double> costs;
    for (std::size_t column = 0; column < formulation.costs.size(); ++column) {
        if (state.column(static_cast<int>(column)) == ArcState::in) fixedCost_ += formulation.costs[column];
        if (state.column(static_cast<int>(column)) != ArcState::free) continue;
        indexOf[column] = static_cast<int>(columns_.size());
        columns_.push_back(static_cast<int>(column));
        costs.push_back(formulation.costs[column]);
    }
    Rows rows;
    for (std::size_t id = 0; id < formulation.rows.size(); ++id) {
        const Formulation::Row& row = formulation.rows[id];
        const OpenRow open = openPart(row, state);
        // The lower side of a cover row can rise later.
        const double lower = row.lower - open.constant, upper = row.upper - open.constant;
        if (open.terms.size() < 2 || (open.least >= lower && open.most <= upper)) continue;
        for (const std::size_t k : open.terms) {
            rows.rowOf.push_back(static_cast<int>(rows_.size()));
            rows.columnOf.push_back(indexOf[at(row.columns[k])]);
            rows.weights.push_back(row.weights[k]);
        }
        rows_.push_back(static_cast<int>(id));
        rows.lower.push_back(bounded(state.rowLower(static_cast<int>(id)) - open.constant));
        rows.upper.push_back(bounded(upper));
    }
    CoinPackedMatrix matrix(true, rows.rowOf.data(), rows.columnOf.data(), rows.weights.data(),
                            static_cast<CoinBigIndex>(rows.weights.size()));
    matrix.setDimensions(static_cast<int>(rows_.size()), static_cast<int>(columns_.size()));
    const std::vector<double> lower(costs.size(), 0), upper(costs.size(), 1);
    solver_->setLogLevel(0);
    solver_->loadProblem(matrix, lower.data(), upper.data(), costs.data(), rows.lower.data(),
                         rows.upper.data());
    solver_->scaling(0);
}

Relaxation::~Relaxation() = default;
Relaxation::Relaxation(Relaxation&&) noexcept = default;
Relaxation& Relaxation::operator=(Relaxation&&) noexcept = default;

void Relaxation::setBounds(const ParticleState& state) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const ArcState value = state.column(columns_[k]);
        const double lower = value == ArcState::in ? 1 : 0, upper = value == ArcState::out ? 0 : 1;
        if (solver_->columnLower()[k] != lower || solver_->columnUpper()[k] != upper)
            solver_->setColumnBounds(static_cast<int>(k), lower, upper);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        if (formulation_->rows[at(rows_[k])].lower > -1e9) continue; // not a cover row
        const double lower = bounded(state.rowLower(rows_[k]));
        if (solver_->rowLower()[k] != lower)
            solver_->setRowBounds(static_cast<int>(k), lower, solver_->rowUpper()[k]);
    }
}

void Relaxation::read(const ParticleState& state) {
    for (std::size_t column = 0; column < values_.size(); ++column) {
        values_[column] = state.column(static_cast<int>(column)) == ArcState::in ? 1 : 0;
        reducedCosts_[column] = 0;
    }
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        values_[at(columns_[k])] = solver_->primalColumnSolution()[k];
        reducedCosts_[at(columns_[k])] = solver_->dualColumnSolution()[k];
    }
}

/// Every column for itself; the solver does not keep its promises about such problems.
Relaxation::Result Relaxation::solveWithoutRows(const ParticleState& state, double cutoff) {
    Result result{Result::Kind::solved, 0};
    for (std::size_t column = 0; column < values_.size(); ++column) {
        const ArcState known = state.column(static_cast<int>(column));
        const double cost = formulation_->costs[column];
        const bool in = known == ArcState::in || (known == ArcState::free && cost < 0);
        values_[column] = in ? 1 : 0;
        reducedCosts_[column] = cost;
        result.bound += in ? cost : 0;
    }
    if (result.bound >= cutoff) result.kind = Result::Kind::tooExpensive;
    return result;
}

Relaxation::Result Relaxation::solve(const ParticleState& state, double cutoff, int iterations) {
    if (rows_.empty()) return solveWithoutRows(state, cutoff);
    setBounds(state);
    solver_->setDualObjectiveLimit(std::isinf(cutoff) ? COIN_DBL_MAX : cutoff - fixedCost_);
    solver_->setMaximumIterations(iterations);
    solver_->dual();
    if (solver_->status() > 3) solver_->primal();
    Result result;
    if (solver_->status() == 1) {
        result.kind = Result::Kind::tooExpensive;
        return result;
    }
    result.bound = solver_->objectiveValue() + fixedCost_;
    if (solver_->status() != 0) return result;
    result.kind = result.bound < cutoff ? Result::Kind::solved : Result::Kind::tooExpensive;
    read(state);
    return result;
}

double Relaxation::fixedShare(const ParticleState& state) const {
    const auto fixed =
        std::ranges::count_if(columns_, [&](int column) { return state.column(column) != ArcState::free; });
    return columns_.empty() ? 0 : static_cast<double>(fixed) / static_cast<double>(columns_.size());
}

Relaxation::Basis Relaxation::basis() const {
    if (!solver_->statusExists()) return {};
    const unsigned char* status = solver_->statusArray();
    return {status, status + columns_.size() + rows_.size()};
}

void Relaxation::setBasis(const Basis& basis) {
    if (!basis.empty()) solver_->copyinStatus(basis.data());
}

} // namespace qm

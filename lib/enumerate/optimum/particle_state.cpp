#include "enumerate/optimum/particle_state.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr double tolerance = 1e-6; ///< of sums of a few whole numbers

} // namespace

ParticleState::ParticleState(SearchState& state, const Formulation& formulation)
    : arcs_(state), formulation_(formulation), columns_(formulation.costs.size(), ArcState::free),
      demanded_(formulation.rows.size(), false), rowsOf_(formulation.costs.size()) {
    for (std::size_t row = 0; row < formulation.rows.size(); ++row)
        for (const int column : formulation.rows[row].columns)
            rowsOf_[at(column)].push_back(static_cast<int>(row));
    for (std::size_t row = 0; row < formulation.rows.size() && consistent_; ++row)
        consistent_ = visitRow(static_cast<int>(row));
    consistent_ = consistent_ && settle();
}

double ParticleState::rowLower(int row) const {
    return demanded_[at(row)] ? 1 : formulation_.rows[at(row)].lower;
}

ParticleState::Mark ParticleState::mark() const {
    return {arcs_.mark(), columnTrail_.size(), demandTrail_.size()};
}

void ParticleState::undo(const Mark& mark) {
    arcs_.undo(mark.arcs);
    while (columnTrail_.size() > mark.columns) {
        columns_[at(columnTrail_.back())] = ArcState::free;
        columnTrail_.pop_back();
    }
    while (demandTrail_.size() > mark.demands) {
        demanded_[at(demandTrail_.back())] = false;
        demandTrail_.pop_back();
    }
    seen_ = mark.arcs;
    propagated_ = told_ = mark.columns;
    demandsSeen_ = mark.demands;
}

bool ParticleState::take(const Decision& decision) {
    if (decision.about == Decision::About::value) {
        if (!arcs_.isFree(decision.variable)) return arcs_.value(decision.variable) == decision.state;
        return arcs_.assign(decision.variable, decision.state) && settle();
    }
    const Formulation::Columns& columns = formulation_.columnsOf[at(decision.variable)];
    return fixColumn(decision.about == Decision::About::fromBefore ? columns.fromBefore : columns.fromAfter,
                     decision.state);
}

bool ParticleState::fixColumn(int column, ArcState value) {
    return set(column, value) && settle();
}

bool ParticleState::set(int column, ArcState value) {
    ArcState& current = columns_[at(column)];
    if (current != ArcState::free) return current == value;
    current = value;
    columnTrail_.push_back(column);
    return true;
}

bool ParticleState::settle() {
    for (;;) {
        if (!arcsToColumns()) return false;
        while (propagated_ < columnTrail_.size() || demandsSeen_ < demandTrail_.size()) {
            if (demandsSeen_ < demandTrail_.size()) {
                if (!visitRow(demandTrail_[demandsSeen_++])) return false;
                continue;
            }
            for (const int row : rowsOf_[at(columnTrail_[propagated_++])])
                if (!visitRow(row)) return false;
        }
        const std::size_t known = arcs_.mark().assignment.assignments;
        if (!columnsToArcs()) return false;
        if (arcs_.mark().assignment.assignments == known && seen_.assignment.assignments == known)
            return true;
    }
}

bool ParticleState::arcsToColumns() {
    for (const int variable : arcs_.assignedSince(seen_)) {
        const auto& [fromBefore, fromAfter] = formulation_.columnsOf[at(variable)];
        const ArcState value = arcs_.value(variable);
        if (const int row = formulation_.coverRowOf[at(variable)]; row >= 0 && value == ArcState::in) {
            if (!demanded_[at(row)]) demandTrail_.push_back(row);
            demanded_[at(row)] = true;
            continue;
        }
        for (const int column : {fromBefore, fromAfter})
            if (column >= 0 && !set(column, value)) return false;
    }
    seen_ = arcs_.mark();
    return true;
}

bool ParticleState::columnsToArcs() {
    while (told_ < columnTrail_.size()) {
        const int column = columnTrail_[told_++];
        const int variable = formulation_.variableOf[at(column)];
        if (variable < 0) continue; // follows from the arcs
        const auto& [fromBefore, fromAfter] = formulation_.columnsOf[at(variable)];
        const auto isOut = [this](int c) { return c < 0 || columns_[at(c)] == ArcState::out; };
        ArcState value = ArcState::free;
        if (columns_[at(column)] == ArcState::in)
            value = ArcState::in;
        else if (isOut(fromBefore) && isOut(fromAfter))
            value = ArcState::out;
        if (value == ArcState::free || arcs_.value(variable) == value) continue;
        if (!arcs_.isFree(variable) || !arcs_.assign(variable, value)) return false;
    }
    return true;
}

/// Fixes the columns to which a row leaves a single value.
bool ParticleState::visitRow(int id) {
    const Formulation::Row& row = formulation_.rows[at(id)];
    double min = 0, max = 0;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const ArcState value = columns_[at(row.columns[k])];
        if (value != ArcState::out) max += std::max(row.weights[k], 0.0);
        if (value != ArcState::out) min += std::min(row.weights[k], 0.0);
        if (value == ArcState::in) min += std::max(row.weights[k], 0.0);
        if (value == ArcState::in) max += std::min(row.weights[k], 0.0);
    }
    const double lower = rowLower(id) - tolerance, upper = row.upper + tolerance;
    if (max < lower || min > upper) return false;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        if (columns_[at(row.columns[k])] != ArcState::free) continue;
        const double weight = std::abs(row.weights[k]);
        const bool positive = row.weights[k] > 0;
        if (max - weight < lower)
            set(row.columns[k], positive ? ArcState::in : ArcState::out);
        else if (min + weight > upper)
            set(row.columns[k], positive ? ArcState::out : ArcState::in);
    }
    return true;
}

} // namespace qm

#include "enumerate/relaxation/column_state.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

constexpr double tolerance = 1e-6; ///< for sums of a few whole numbers

} // namespace

ColumnState::ColumnState(SearchState& state, const Formulation& formulation)
    : arcs_(state), formulation_(formulation), columns_(formulation.costs.size(), ArcState::free),
      demanded_(formulation.rows.size(), false), rowsOf_(formulation.rowsOfColumns()) {
    for (const RowId row : formulation.rows.ids())
        consistent_ = consistent_ && visitRow(row);
    // Of the variables that have a value already, only few may belong to the formulation.
    for (const VariableId variable : formulation.variableOf)
        consistent_ = consistent_ && (!variable.valid() || state.isFree(variable) || passOn(variable));
    seen_ = state.mark();
    consistent_ = consistent_ && settle();
}

double ColumnState::rowLower(RowId row) const {
    return row.idx() < demanded_.size() && demanded_[row] ? 1 : formulation_.rows[row].lower;
}

ColumnState::Mark ColumnState::mark() const {
    return {arcs_.mark(), columns_.given().size(), demanded_.given().size()};
}

void ColumnState::undo(const Mark& mark) {
    arcs_.undo(mark.arcs);
    columns_.undo(mark.columns);
    demanded_.undo(mark.demands);
    seen_ = mark.arcs;
    propagated_ = told_ = mark.columns;
    demandsSeen_ = mark.demands;
}

bool ColumnState::take(const Decision& decision) {
    if (decision.about == Decision::About::value)
        return arcs_.assign(decision.variable, decision.state) && settle();
    const Formulation::Columns columns = formulation_.columnsOf[decision.variable];
    return fixColumn(decision.about == Decision::About::fromBefore ? columns.fromBefore : columns.fromAfter,
                     decision.state);
}

bool ColumnState::fixColumn(ColumnId column, ArcState value) {
    return set(column, value) && settle();
}

bool ColumnState::set(ColumnId column, ArcState value) {
    return columns_.give(column, value) || columns_[column] == value;
}

bool ColumnState::settle() {
    for (;;) {
        if (!arcsToColumns() || !rowsToColumns()) return false;
        const std::size_t known = arcs_.mark().assignment.assignments;
        if (!columnsToArcs()) return false;
        if (arcs_.mark().assignment.assignments == known && seen_.assignment.assignments == known)
            return true;
    }
}

bool ColumnState::arcsToColumns() {
    for (const VariableId variable : arcs_.assignedSince(seen_))
        if (!passOn(variable)) return false;
    seen_ = arcs_.mark();
    return true;
}

/// Visits the rows that are demanded, or have columns with values, since the last time.
bool ColumnState::rowsToColumns() {
    for (;;) {
        while (demandsSeen_ < demanded_.given().size())
            if (!visitRow(demanded_.given()[demandsSeen_++])) return false;
        if (propagated_ == columns_.given().size()) return true;
        for (const RowId row : rowsOf_[columns_.given()[propagated_++]])
            if (!visitRow(row)) return false;
    }
}

/// Passes the value of a variable on to its columns, or demands that it be covered.
bool ColumnState::passOn(VariableId variable) {
    const auto [fromBefore, fromAfter, cover] = formulation_.columnsOf[variable];
    const ArcState value = arcs_.value(variable);
    if (cover.valid() && value == ArcState::in) {
        demanded_.give(cover, true);
        return true;
    }
    for (const ColumnId column : {fromBefore, fromAfter})
        if (column.valid() && !set(column, value)) return false;
    return true;
}

bool ColumnState::columnsToArcs() {
    while (told_ < columns_.given().size()) {
        const ColumnId column = columns_.given()[told_++];
        const VariableId variable = formulation_.variableOf[column];
        if (!variable.valid()) continue; // its value follows from the variables
        const auto [fromBefore, fromAfter, cover] = formulation_.columnsOf[variable];
        const auto isOut = [this](ColumnId c) { return !c.valid() || columns_[c] == ArcState::out; };
        ArcState value = ArcState::free;
        if (columns_[column] == ArcState::in)
            value = ArcState::in;
        else if (isOut(fromBefore) && isOut(fromAfter))
            value = ArcState::out;
        if (value != ArcState::free && !arcs_.assign(variable, value)) return false;
    }
    return true;
}

/// Fixes the columns for which a row leaves only one value.
/// \return false if the row cannot be satisfied
bool ColumnState::visitRow(RowId id) {
    const Formulation::Row& row = formulation_.rows[id];
    double min = 0, max = 0;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const ArcState value = columns_[row.columns[k]];
        if (value != ArcState::out) max += std::max(row.weights[k], 0.0);
        if (value != ArcState::out) min += std::min(row.weights[k], 0.0);
        if (value == ArcState::in) min += std::max(row.weights[k], 0.0);
        if (value == ArcState::in) max += std::min(row.weights[k], 0.0);
    }
    const double lower = rowLower(id) - tolerance, upper = row.upper + tolerance;
    if (max < lower || min > upper) return false;
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        if (columns_[row.columns[k]] != ArcState::free) continue;
        const double weight = std::abs(row.weights[k]);
        const bool positive = row.weights[k] > 0;
        if (max - weight < lower)
            set(row.columns[k], arcState(positive));
        else if (min + weight > upper)
            set(row.columns[k], arcState(!positive));
    }
    return true;
}

} // namespace qm

#include "enumerate/relaxation/formulation_columns.h"

#include "base/infinity.h"
#include "base/sort_unique.h"

#include <algorithm>

namespace qm {
FormulationColumns::FormulationColumns(const SearchState& state, const std::vector<VariableId>& variables)
    : state_(state), problem_(state.problem()), ours_(variables) {
    for (const VariableId variable : variables)
        crossings_.insert(crossings_.end(), state.crossingsOf(variable).begin(),
                          state.crossingsOf(variable).end());
    sortUnique(crossings_);
    if (problem_.gaps) {
        for (const VariableId variable : variables)
            knowChain(state.chainOf(variable));
        knowCovered();
        for (const ChainId chain : known_)
            addChain(problem_.chains[chain]);
    } else {
        for (const VariableId variable : variables)
            result_.columnsOf.at(variable).fromBefore = newColumn(variable);
    }
}

bool FormulationColumns::isForeign(VariableId variable) const {
    return state_.isFree(variable) && !std::ranges::binary_search(ours_, variable);
}
bool FormulationColumns::isForeign(const Chain& chain) const {
    return std::ranges::any_of(chain.variables(), [this](VariableId v) { return isForeign(v); });
}
bool FormulationColumns::isForeign(const Crossing& crossing) const {
    return std::ranges::any_of(crossing.arcs(), [this](VariableId arc) { return isForeign(arc); });
}

void FormulationColumns::knowChain(ChainId chain) {
    if (!chain.valid() || known_.contains(chain) || isForeign(problem_.chains[chain])) return;
    known_.insert(chain);
    fresh_.push_back(chain);
}

/// Adds the lines that are covered already but may still be cracked somewhere, and all crossings of the
/// chains added.
void FormulationColumns::knowCovered() {
    while (!fresh_.empty()) {
        const Chain& chain = problem_.chains[fresh_.back()];
        fresh_.pop_back();
        for (const VariableId v : chain.variables())
            for (const CrossingId id : state_.crossingsOf(v)) {
                crossings_.push_back(id);
                const Crossing& crossing = problem_.crossings[id];
                if (std::ranges::any_of(crossing.arcs(), [this](VariableId arc) { return isOut(arc); }))
                    continue;
                for (const VariableId arc : crossing.arcs())
                    knowChain(state_.chainOf(arc));
            }
    }
    sortUnique(crossings_);
}

ColumnId FormulationColumns::newColumn(VariableId variable) {
    result_.costs.push_back(state_.isFree(variable) ? problem_.costs[variable] : 0);
    result_.variableOf.push_back(variable);
    return result_.costs.nextId() - 1;
}

/// A variable that is out divides a chain: before it only the particle from before can walk, behind it only
/// the other.
void FormulationColumns::addChain(const Chain& chain) {
    VariableId firstOut = chain.first + chain.count, lastOut = chain.first - 1;
    for (const VariableId v : chain.variables())
        if (isOut(v)) {
            firstOut = std::min(firstOut, v);
            lastOut = v;
        }
    for (const VariableId v : chain.variables()) {
        if (isOut(v)) continue;
        Formulation::Columns& here = result_.columnsOf.at(v);
        if (chain.coveredBefore && v < firstOut) here.fromBefore = newColumn(v);
        if (chain.coveredAfter && v > lastOut) here.fromAfter = newColumn(v);
        if (here.fromBefore.valid() && here.fromAfter.valid()) {
            here.cover = result_.rows.nextId();
            result_.rows.push_back({{here.fromBefore, here.fromAfter}, {1, 1}, isIn(v) ? 1.0 : -infinity, 1});
        }
        if (v == chain.first) continue;
        const Formulation::Columns previous = columns(v - 1);
        if (previous.fromBefore.valid() && here.fromBefore.valid())
            addLowerLimit(Expression{}.add(previous.fromBefore, 1).add(here.fromBefore, -1), 0);
        if (previous.fromAfter.valid() && here.fromAfter.valid())
            addLowerLimit(Expression{}.add(here.fromAfter, 1).add(previous.fromAfter, -1), 0);
    }
}

ColumnId FormulationColumns::newFlag() {
    result_.costs.push_back(0);
    result_.variableOf.push_back({});
    return result_.costs.nextId() - 1;
}

Expression FormulationColumns::present(VariableId variable) const {
    Expression expression;
    const Formulation::Columns both = columns(variable);
    expression.add(both.fromBefore, 1).add(both.fromAfter, 1);
    if (!both.any()) expression.constant = isIn(variable) ? 1 : 0;
    return expression;
}

void FormulationColumns::addLowerLimit(const Expression& expression, double bound) {
    Formulation::Row row{{}, {}, bound - expression.constant, infinity};
    double min = 0;
    for (const auto& [column, weight] : expression.terms) {
        if (weight == 0) continue;
        row.columns.push_back(column);
        row.weights.push_back(weight);
        min += std::min(weight, 0.0);
    }
    if (min < row.lower) result_.rows.push_back(std::move(row));
}

void FormulationColumns::addCost(const Expression& expression, double factor) {
    for (const auto& [column, weight] : expression.terms)
        result_.costs[column] += factor * weight;
    result_.constant += factor * expression.constant;
}

bool FormulationColumns::isWall(const CrossingSide& side) const {
    return !side.node.valid() && isIn(side.before) && isIn(side.after);
}

bool FormulationColumns::consecutive(const CrossingSide& side) const {
    return !isWall(side) && side.after == side.before + 1 && !problem_.isConstant(side.after) &&
           state_.chainOf(side.before) == state_.chainOf(side.after) && columns(side.before).any() &&
           columns(side.after).any();
}

bool FormulationColumns::isPlain(const Crossing& crossing) const {
    return problem_.gaps && !crossing.open && !isForeign(crossing) && consecutive(crossing.sides[0]) &&
           consecutive(crossing.sides[1]);
}

Expression FormulationColumns::pass(const CrossingSide& side) const {
    return Expression{}.add(columns(side.after).fromBefore, 1).add(columns(side.before).fromAfter, 1);
}

Expression FormulationColumns::surePass(const CrossingSide& side) const {
    if (isOut(side.before) || isOut(side.after)) return {};
    if (isWall(side)) return {.terms = {}, .constant = 1};
    if (consecutive(side)) return pass(side);
    Expression expression;
    if (side.before == problem_.in()) expression.add(columns(side.after).fromBefore, 1);
    if (side.after == problem_.in()) expression.add(columns(side.before).fromAfter, 1);
    return expression;
}

std::array<Expression, 2> FormulationColumns::particleStops(const CrossingSide& side) const {
    const Formulation::Columns before = columns(side.before), after = columns(side.after);
    return {Expression{}.add(before.fromBefore, 1).add(after.fromBefore, -1),
            Expression{}.add(after.fromAfter, 1).add(before.fromAfter, -1)};
}

} // namespace qm

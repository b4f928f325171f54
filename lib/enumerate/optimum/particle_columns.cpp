#include "enumerate/optimum/particle_columns.h"

#include <algorithm>
#include <limits>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

constexpr double infinity = std::numeric_limits<double>::infinity();

void makeUnique(std::vector<int>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

ParticleColumns::ParticleColumns(const SearchState& state, const std::vector<int>& variables)
    : state_(state), problem_(state.problem()), ours_(problem_.domains.size(), false),
      known_(problem_.chains.size(), false) {
    result_.columnsOf.resize(problem_.domains.size());
    result_.coverRowOf.assign(problem_.domains.size(), -1);
    for (const int variable : variables) {
        ours_[at(variable)] = true;
        crossings_.insert(crossings_.end(), state.crossingsOf(variable).begin(),
                          state.crossingsOf(variable).end());
    }
    makeUnique(crossings_);
    if (problem_.gaps) {
        for (const int variable : variables)
            knowChain(state.chainOf(variable));
        knowCovered();
        for (std::size_t chain = 0; chain < problem_.chains.size(); ++chain)
            if (known_[chain]) addChain(problem_.chains[chain]);
    } else {
        for (const int variable : variables)
            result_.columnsOf[at(variable)].fromBefore = newColumn(variable);
    }
}

bool ParticleColumns::isForeign(int variable) const {
    return state_.isFree(variable) && !ours_[at(variable)];
}
bool ParticleColumns::isForeign(const Chain& chain) const {
    for (int v = chain.first; v < chain.first + chain.count; ++v)
        if (isForeign(v)) return true;
    return false;
}
bool ParticleColumns::isForeign(const Crossing& crossing) const {
    return std::ranges::any_of(crossing.sides, [this](const CrossingSide& side) {
        return isForeign(side.before) || isForeign(side.after);
    });
}

void ParticleColumns::knowChain(int chain) {
    if (chain < 0 || known_[at(chain)] || isForeign(problem_.chains[at(chain)])) return;
    known_[at(chain)] = true;
    fresh_.push_back(chain);
}

/// Takes in the lines that are covered already but may still be cracked somewhere, and all crossings of the
/// chains taken in.
void ParticleColumns::knowCovered() {
    while (!fresh_.empty()) {
        const Chain& chain = problem_.chains[at(fresh_.back())];
        fresh_.pop_back();
        for (int v = chain.first; v < chain.first + chain.count; ++v)
            for (const int id : state_.crossingsOf(v)) {
                crossings_.push_back(id);
                const Crossing& crossing = problem_.crossings[at(id)];
                if (anyOut(crossing)) continue;
                for (const CrossingSide& side : crossing.sides)
                    for (const int arc : {side.before, side.after})
                        knowChain(state_.chainOf(arc));
            }
    }
    makeUnique(crossings_);
}

bool ParticleColumns::anyOut(const Crossing& crossing) const {
    return std::ranges::any_of(
        crossing.sides, [this](const CrossingSide& side) { return isOut(side.before) || isOut(side.after); });
}

int ParticleColumns::newColumn(int variable) {
    result_.costs.push_back(state_.isFree(variable) ? problem_.costs[at(variable)] : 0);
    result_.variableOf.push_back(variable);
    return static_cast<int>(result_.costs.size()) - 1;
}

/// An arc that is out divides a chain: before it only one particle runs, after it only the other.
void ParticleColumns::addChain(const Chain& chain) {
    int firstOut = chain.first + chain.count, lastOut = chain.first - 1;
    for (int v = chain.first; v < chain.first + chain.count; ++v)
        if (isOut(v)) {
            firstOut = std::min(firstOut, v);
            lastOut = v;
        }
    for (int v = chain.first; v < chain.first + chain.count; ++v) {
        if (isOut(v)) continue;
        Formulation::Columns& here = result_.columnsOf[at(v)];
        if (chain.coveredBefore && v < firstOut) here.fromBefore = newColumn(v);
        if (chain.coveredAfter && v > lastOut) here.fromAfter = newColumn(v);
        if (here.fromBefore >= 0 && here.fromAfter >= 0) {
            result_.coverRowOf[at(v)] = static_cast<int>(result_.rows.size());
            result_.rows.push_back({{here.fromBefore, here.fromAfter}, {1, 1}, isIn(v) ? 1.0 : -infinity, 1});
        }
        if (v == chain.first) continue;
        const Formulation::Columns& last = columns(v - 1);
        if (last.fromBefore >= 0 && here.fromBefore >= 0)
            atLeast(Expression{}.add(last.fromBefore, 1).add(here.fromBefore, -1), 0);
        if (last.fromAfter >= 0 && here.fromAfter >= 0)
            atLeast(Expression{}.add(here.fromAfter, 1).add(last.fromAfter, -1), 0);
    }
}

int ParticleColumns::newFlag() {
    result_.costs.push_back(0);
    result_.variableOf.push_back(-1);
    return static_cast<int>(result_.costs.size()) - 1;
}

Expression ParticleColumns::present(int variable) const {
    Expression expression;
    const auto& [fromBefore, fromAfter] = columns(variable);
    if (fromBefore >= 0) expression.add(fromBefore, 1);
    if (fromAfter >= 0) expression.add(fromAfter, 1);
    if (!columns(variable).any()) expression.constant = isIn(variable) ? 1 : 0;
    return expression;
}

void ParticleColumns::atLeast(const Expression& expression, double bound) {
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

void ParticleColumns::addCost(const Expression& expression, double factor) {
    for (const auto& [column, weight] : expression.terms)
        result_.costs[at(column)] += factor * weight;
    result_.constant += factor * expression.constant;
}

bool ParticleColumns::isWall(const CrossingSide& side) const {
    return side.node < 0 && isIn(side.before) && isIn(side.after);
}

bool ParticleColumns::consecutive(const CrossingSide& side) const {
    return !isWall(side) && side.after == side.before + 1 && side.after < problem_.variables() &&
           state_.chainOf(side.before) == state_.chainOf(side.after) && columns(side.before).any() &&
           columns(side.after).any();
}

Expression ParticleColumns::pass(const CrossingSide& side) const {
    Expression expression;
    if (columns(side.after).fromBefore >= 0) expression.add(columns(side.after).fromBefore, 1);
    if (columns(side.before).fromAfter >= 0) expression.add(columns(side.before).fromAfter, 1);
    return expression;
}

Expression ParticleColumns::surePass(const CrossingSide& side) const {
    if (isOut(side.before) || isOut(side.after)) return {};
    if (isWall(side)) {
        Expression always;
        always.constant = 1;
        return always;
    }
    if (consecutive(side)) return pass(side);
    Expression expression;
    const bool enters = side.before == problem_.in(), leaves = side.after == problem_.in();
    if (enters && columns(side.after).fromBefore >= 0) expression.add(columns(side.after).fromBefore, 1);
    if (leaves && columns(side.before).fromAfter >= 0) expression.add(columns(side.before).fromAfter, 1);
    return expression;
}

std::array<Expression, 2> ParticleColumns::particleStops(const CrossingSide& side) const {
    const auto& before = columns(side.before);
    const auto& after = columns(side.after);
    std::array<Expression, 2> stops;
    if (before.fromBefore >= 0) stops[0].add(before.fromBefore, 1);
    if (after.fromBefore >= 0) stops[0].add(after.fromBefore, -1);
    if (after.fromAfter >= 0) stops[1].add(after.fromAfter, 1);
    if (before.fromAfter >= 0) stops[1].add(before.fromAfter, -1);
    return stops;
}

} // namespace qm

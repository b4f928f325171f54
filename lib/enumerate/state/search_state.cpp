#include "enumerate/state/search_state.h"

#include "enumerate/state/junction_rule.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<int> capacities(const Problem& problem) {
    std::vector<int> result;
    for (const CrackNode& node : problem.nodes)
        result.push_back(node.capacity);
    return result;
}

} // namespace

SearchState::SearchState(const Problem& problem)
    : problem_(problem), values_(problem.domains.size(), ArcState::free),
      chainOf_(problem.domains.size(), -1), crossingsOf_(problem.domains.size()),
      nodeOfChain_(problem.chains.size(), -1), crossingsOfNode_(problem.nodes.size()),
      hulls_(problem.chains.size()), inCount_(problem.chains.size(), 0),
      promised_(problem.chains.size(), false), counted_(problem.crossings.size(), false),
      cracks_(capacities(problem)), free_(static_cast<int>(problem.domains.size())) {
    for (const double cost : problem.costs)
        bound_ += std::min(cost, 0.0);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c) {
        bound_ += cornerBound(static_cast<int>(c));
        cornersCost_ = cornersCost_ || problem.crossings[c].cornerCost != 0;
    }
    for (std::size_t c = 0; c < problem.chains.size(); ++c)
        for (int k = 0; k < problem.chains[c].count; ++k)
            chainOf_[at(problem.chains[c].first + k)] = static_cast<int>(c);
    for (std::size_t n = 0; n < problem.nodes.size(); ++n)
        if (problem.nodes[n].chain >= 0) nodeOfChain_[at(problem.nodes[n].chain)] = static_cast<int>(n);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c) {
        for (const int arc : arcsOf(problem.crossings[c]))
            if (crossingsOf_[at(arc)].empty() || crossingsOf_[at(arc)].back() != static_cast<int>(c))
                crossingsOf_[at(arc)].push_back(static_cast<int>(c));
        for (const CrossingSide& side : problem.crossings[c].sides)
            if (side.node >= 0) crossingsOfNode_[at(side.node)].push_back(static_cast<int>(c));
    }
    for (std::size_t v = 0; v < problem.domains.size(); ++v)
        if (problem.domains[v] != ArcState::free)
            consistent_ = consistent_ && set(static_cast<int>(v), problem.domains[v]);
    consistent_ = consistent_ && propagate();
}

SearchState::Mark SearchState::mark() const {
    return {assigned_.size(),  hullTrail_.size(),    countedTrail_.size(),
            cracks_.changes(), promiseTrail_.size(), bound_};
}

void SearchState::undo(const Mark& mark) {
    while (assigned_.size() > mark.assignments) {
        const int variable = assigned_.back();
        assigned_.pop_back();
        const int chain = chainOf_[at(variable)];
        if (chain >= 0 && value(variable) == ArcState::in) --inCount_[at(chain)];
        values_[at(variable)] = ArcState::free;
        ++free_;
    }
    while (hullTrail_.size() > mark.hulls) {
        hulls_[at(hullTrail_.back().chain)] = hullTrail_.back().before;
        hullTrail_.pop_back();
    }
    while (countedTrail_.size() > mark.counted) {
        counted_[at(countedTrail_.back())] = false;
        countedTrail_.pop_back();
    }
    cracks_.undo(mark.cracks);
    while (promiseTrail_.size() > mark.promises) {
        promised_[at(promiseTrail_.back())] = false;
        promiseTrail_.pop_back();
    }
    propagated_ = assigned_.size();
    bound_ = mark.bound;
}

bool SearchState::assign(int variable, ArcState value) {
    return set(variable, value) && propagate();
}

bool SearchState::set(int variable, ArcState value) {
    ArcState& current = values_[at(variable)];
    if (current != ArcState::free) return current == value;
    const double cornersBefore = cornersCost_ ? cornerBounds(variable) : 0;
    current = value;
    assigned_.push_back(variable);
    --free_;
    if (cornersCost_) bound_ += cornerBounds(variable) - cornersBefore;
    const double cost = problem_.costs[at(variable)];
    bound_ += value == ArcState::in ? std::max(cost, 0.0) : -std::min(cost, 0.0);
    if (value == ArcState::in && chainOf_[at(variable)] >= 0) ++inCount_[at(chainOf_[at(variable)])];
    return true;
}

double SearchState::cornerBound(int id) const {
    const Crossing& crossing = problem_.crossings[at(id)];
    const auto arcs = [&](const CrossingSide& side) {
        const auto counts = [&](int arc) {
            return crossing.cornerCost < 0 ? value(arc) != ArcState::out : value(arc) == ArcState::in;
        };
        return (counts(side.before) ? 1 : 0) + (counts(side.after) ? 1 : 0);
    };
    return crossing.cornerCost * cornersAt(arcs(crossing.sides[0]), arcs(crossing.sides[1]));
}

double SearchState::cornerBounds(int variable) const {
    double sum = 0;
    for (const int crossing : crossingsOf_[at(variable)])
        sum += cornerBound(crossing);
    return sum;
}

bool SearchState::propagate() {
    while (propagated_ < assigned_.size()) {
        const int variable = assigned_[propagated_++];
        if (problem_.gaps && chainOf_[at(variable)] >= 0 && !visitChain(variable)) return false;
        for (const int crossing : crossingsOf_[at(variable)])
            if (!visitCrossing(crossing)) return false;
    }
    return true;
}

bool SearchState::visitCrossing(int id) {
    return (problem_.crossings[at(id)].open || applyRule2(id)) && (!problem_.gaps || countCrossing(id));
}

bool SearchState::applyRule2(int id) {
    const std::array<int, 4> arcs = arcsOf(problem_.crossings[at(id)]);
    unsigned index = 0;
    for (int k = 3; k >= 0; --k) {
        const ArcState state = value(arcs[at(k)]);
        index = index * 3 + (state == ArcState::free ? 2U : static_cast<unsigned>(state));
    }
    const JunctionConclusion& conclusion = concludeAtJunction(index);
    if (!conclusion.possible) return false;
    for (unsigned k = 0; k < 4; ++k) {
        if ((conclusion.forcedIn >> k & 1) && !set(arcs[k], ArcState::in)) return false;
        if ((conclusion.forcedOut >> k & 1) && !set(arcs[k], ArcState::out)) return false;
    }
    return true;
}

std::vector<int> SearchState::assignedSince(const Mark& mark) const {
    return {assigned_.begin() + static_cast<std::ptrdiff_t>(mark.assignments), assigned_.end()};
}

Assignment SearchState::assignment() const {
    Assignment result;
    result.reserve(values_.size());
    for (const ArcState state : values_)
        result.push_back(state == ArcState::in ? 1 : 0);
    return result;
}

} // namespace qm

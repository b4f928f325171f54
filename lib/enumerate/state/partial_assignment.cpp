#include "enumerate/state/partial_assignment.h"

#include <algorithm>

namespace qm {
PartialAssignment::PartialAssignment(const Problem& problem)
    : problem_(problem), values_(problem.domains.size(), ArcState::free), chainOf_(problem.domains.size()),
      crossingsOf_(problem.domains.size()), inCount_(problem.chains.size(), 0),
      free_(static_cast<int>(problem.domains.size())) {
    for (const double cost : problem.costs)
        bound_ += std::min(cost, 0.0);
    for (const CrossingId crossing : problem.crossings.ids()) {
        bound_ += cornerBound(crossing);
        cornersCost_ = cornersCost_ || problem.crossings[crossing].cornerCost != 0;
    }
    for (const ChainId chain : problem.chains.ids())
        for (const VariableId variable : problem.chains[chain].variables())
            chainOf_[variable] = chain;
    for (const CrossingId crossing : problem.crossings.ids())
        for (const VariableId arc : problem.crossings[crossing].arcs())
            if (crossingsOf_[arc].empty() || crossingsOf_[arc].back() != crossing)
                crossingsOf_[arc].push_back(crossing);
}

bool PartialAssignment::set(VariableId variable, ArcState value) {
    ArcState& current = values_[variable];
    if (current != ArcState::free) return current == value;
    const double cornersBefore = cornersCost_ ? cornerBounds(variable) : 0;
    current = value;
    assigned_.push_back(variable);
    --free_;
    if (cornersCost_) bound_ += cornerBounds(variable) - cornersBefore;
    const double cost = problem_.costs[variable];
    bound_ += value == ArcState::in ? std::max(cost, 0.0) : -std::min(cost, 0.0);
    if (value == ArcState::in && chainOf_[variable].valid()) ++inCount_[chainOf_[variable]];
    return true;
}

void PartialAssignment::undo(const Mark& mark) {
    while (assigned_.size() > mark.assignments) {
        const VariableId variable = assigned_.back();
        assigned_.pop_back();
        const ChainId chain = chainOf_[variable];
        if (chain.valid() && value(variable) == ArcState::in) --inCount_[chain];
        values_[variable] = ArcState::free;
        ++free_;
    }
    bound_ = mark.bound;
}

double PartialAssignment::cornerBound(CrossingId id) const {
    const Crossing& crossing = problem_.crossings[id];
    return crossing.cornerCost * crossing.corners([&](VariableId arc) {
        return crossing.cornerCost < 0 ? value(arc) != ArcState::out : value(arc) == ArcState::in;
    });
}

double PartialAssignment::cornerBounds(VariableId variable) const {
    double sum = 0;
    for (const CrossingId crossing : crossingsOf_[variable])
        sum += cornerBound(crossing);
    return sum;
}

Assignment PartialAssignment::assignment() const {
    Assignment result(values_.size());
    std::ranges::transform(values_, result.begin(),
                           [](ArcState state) { return state == ArcState::in ? 1 : 0; });
    return result;
}

} // namespace qm

#include "enumerate/state/partial_assignment.h"

#include <algorithm>
#include <span>

namespace qm {

PartialAssignment::PartialAssignment(const Problem& problem)
    : problem_(problem), values_(problem.domains.size(), ArcState::free), chainOf_(problem.domains.size()),
      crossingsOf_(problem.domains.size()), inCount_(problem.chains.size(), 0) {
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
    if (!isFree(variable)) return this->value(variable) == value;
    const double cornersBefore = cornersCost_ ? cornerBounds(variable) : 0;
    values_.give(variable, value);
    if (cornersCost_) bound_ += cornerBounds(variable) - cornersBefore;
    const double cost = problem_.costs[variable];
    bound_ += value == ArcState::in ? std::max(cost, 0.0) : -std::min(cost, 0.0);
    if (value == ArcState::in && chainOf_[variable].valid()) ++inCount_[chainOf_[variable]];
    return true;
}

void PartialAssignment::undo(const Mark& mark) {
    for (const VariableId variable : std::span(assigned()).subspan(mark.assignments))
        if (const ChainId chain = chainOf_[variable]; chain.valid() && value(variable) == ArcState::in)
            --inCount_[chain];
    values_.undo(mark.assignments);
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
    Assignment result;
    result.reserve(values_.size());
    for (const VariableId variable : problem_.domains.ids())
        result.push_back(value(variable) == ArcState::in ? 1 : 0);
    return result;
}

} // namespace qm

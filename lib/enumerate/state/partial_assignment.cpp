#include "enumerate/state/partial_assignment.h"

#include "enumerate/state/junction_rule.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

PartialAssignment::PartialAssignment(const Problem& problem)
    : problem_(problem), values_(problem.domains.size(), ArcState::free),
      chainOf_(problem.domains.size(), -1), crossingsOf_(problem.domains.size()),
      inCount_(problem.chains.size(), 0), free_(static_cast<int>(problem.domains.size())) {
    for (const double cost : problem.costs)
        bound_ += std::min(cost, 0.0);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c) {
        bound_ += cornerBound(static_cast<int>(c));
        cornersCost_ = cornersCost_ || problem.crossings[c].cornerCost != 0;
    }
    for (std::size_t c = 0; c < problem.chains.size(); ++c)
        for (int k = 0; k < problem.chains[c].count; ++k)
            chainOf_[at(problem.chains[c].first + k)] = static_cast<int>(c);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c)
        for (const int arc : arcsOf(problem.crossings[c]))
            if (crossingsOf_[at(arc)].empty() || crossingsOf_[at(arc)].back() != static_cast<int>(c))
                crossingsOf_[at(arc)].push_back(static_cast<int>(c));
}

bool PartialAssignment::set(int variable, ArcState value) {
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

void PartialAssignment::undo(const Mark& mark) {
    while (assigned_.size() > mark.assignments) {
        const int variable = assigned_.back();
        assigned_.pop_back();
        const int chain = chainOf_[at(variable)];
        if (chain >= 0 && value(variable) == ArcState::in) --inCount_[at(chain)];
        values_[at(variable)] = ArcState::free;
        ++free_;
    }
    bound_ = mark.bound;
}

double PartialAssignment::cornerBound(int id) const {
    const Crossing& crossing = problem_.crossings[at(id)];
    const auto arcs = [&](const CrossingSide& side) {
        const auto counts = [&](int arc) {
            return crossing.cornerCost < 0 ? value(arc) != ArcState::out : value(arc) == ArcState::in;
        };
        return (counts(side.before) ? 1 : 0) + (counts(side.after) ? 1 : 0);
    };
    return crossing.cornerCost * cornersAt(arcs(crossing.sides[0]), arcs(crossing.sides[1]));
}

double PartialAssignment::cornerBounds(int variable) const {
    double sum = 0;
    for (const int crossing : crossingsOf_[at(variable)])
        sum += cornerBound(crossing);
    return sum;
}

Assignment PartialAssignment::assignment() const {
    Assignment result;
    result.reserve(values_.size());
    for (const ArcState state : values_)
        result.push_back(state == ArcState::in ? 1 : 0);
    return result;
}

} // namespace qm

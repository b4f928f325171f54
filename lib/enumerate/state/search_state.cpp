#include "enumerate/state/search_state.h"

#include "enumerate/state/junction_rule.h"

namespace qm {

SearchState::SearchState(const Problem& problem)
    : problem_(problem), assignment_(problem), lines_(problem, assignment_),
      cracks_(problem, assignment_, lines_) {
    for (const VariableId v : problem.domains.ids())
        if (problem.domains[v] != ArcState::free)
            consistent_ = consistent_ && assignment_.set(v, problem.domains[v]);
    consistent_ = consistent_ && propagate();
}

void SearchState::undo(const Mark& mark) {
    assignment_.undo(mark.assignment);
    lines_.undo(mark.lines);
    cracks_.undo(mark.cracks);
    propagated_ = assignment_.assigned().size();
}

bool SearchState::decideCover(ChainId chain, bool full) {
    if (full) return lines_.cover(chain) && propagate();
    if (coverOfChain(chain) == Cover::full) return false;
    lines_.promiseGap(chain);
    return cracks_.visitCovered(chain) && propagate();
}

bool SearchState::propagate() {
    while (propagated_ < assignment_.assigned().size()) {
        const VariableId variable = assignment_.assigned()[propagated_++];
        if (problem_.gaps && chainOf(variable).valid() && !visitLine(variable)) return false;
        for (const CrossingId crossing : crossingsOf(variable))
            if (!visitCrossing(crossing)) return false;
    }
    return true;
}

bool SearchState::visitLine(VariableId variable) {
    if (!lines_.visit(variable)) return false;
    const ChainId chain = chainOf(variable);
    const bool decided = value(variable) == ArcState::out || lines_.isFull(chain);
    return !decided || cracks_.visitCovered(chain);
}

bool SearchState::visitCrossing(CrossingId id) {
    const Crossing& crossing = problem_.crossings[id];
    return (crossing.open || concludeAround(crossing, assignment_)) &&
           (!problem_.gaps || cracks_.visitCrossing(id));
}

std::vector<VariableId> SearchState::assignedSince(const Mark& mark) const {
    const std::vector<VariableId>& assigned = assignment_.assigned();
    return {assigned.begin() + static_cast<std::ptrdiff_t>(mark.assignment.assignments), assigned.end()};
}

} // namespace qm

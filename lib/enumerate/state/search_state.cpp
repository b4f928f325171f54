#include "enumerate/state/search_state.h"

#include "enumerate/state/junction_rule.h"

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Rule 2 at a crossing.
bool concludeAround(const Crossing& crossing, PartialAssignment& assignment) {
    const std::array<int, 4> arcs = arcsOf(crossing);
    unsigned index = 0;
    for (int k = 3; k >= 0; --k) {
        const ArcState state = assignment.value(arcs[at(k)]);
        index = index * 3 + (state == ArcState::free ? 2U : static_cast<unsigned>(state));
    }
    const JunctionConclusion& conclusion = concludeAtJunction(index);
    if (!conclusion.possible) return false;
    for (unsigned k = 0; k < 4; ++k) {
        if ((conclusion.forcedIn >> k & 1) && !assignment.set(arcs[k], ArcState::in)) return false;
        if ((conclusion.forcedOut >> k & 1) && !assignment.set(arcs[k], ArcState::out)) return false;
    }
    return true;
}

} // namespace

SearchState::SearchState(const Problem& problem)
    : problem_(problem), assignment_(problem), lines_(problem, assignment_),
      cracks_(problem, assignment_, lines_) {
    for (std::size_t v = 0; v < problem.domains.size(); ++v)
        if (problem.domains[v] != ArcState::free)
            consistent_ = consistent_ && assignment_.set(static_cast<int>(v), problem.domains[v]);
    consistent_ = consistent_ && propagate();
}

void SearchState::undo(const Mark& mark) {
    assignment_.undo(mark.assignment);
    lines_.undo(mark.lines);
    cracks_.undo(mark.cracks);
    propagated_ = assignment_.assigned().size();
}

bool SearchState::decideCover(int chain, bool full) {
    if (full) return lines_.cover(chain) && propagate();
    if (coverOfChain(chain) == Cover::full) return false;
    lines_.promiseGap(chain);
    return cracks_.visitCovered(chain) && propagate();
}

bool SearchState::propagate() {
    while (propagated_ < assignment_.assigned().size()) {
        const int variable = assignment_.assigned()[propagated_++];
        if (problem_.gaps && chainOf(variable) >= 0 && !visitLine(variable)) return false;
        for (const int crossing : crossingsOf(variable))
            if (!visitCrossing(crossing)) return false;
    }
    return true;
}

bool SearchState::visitLine(int variable) {
    if (!lines_.visit(variable)) return false;
    const int chain = chainOf(variable);
    const bool decided = value(variable) == ArcState::out || lines_.isFull(chain);
    return !decided || cracks_.visitCovered(chain);
}

bool SearchState::visitCrossing(int id) {
    const Crossing& crossing = problem_.crossings[at(id)];
    return (crossing.open || concludeAround(crossing, assignment_)) &&
           (!problem_.gaps || cracks_.visitCrossing(id));
}

std::vector<int> SearchState::assignedSince(const Mark& mark) const {
    const std::vector<int>& assigned = assignment_.assigned();
    return {assigned.begin() + static_cast<std::ptrdiff_t>(mark.assignment.assignments), assigned.end()};
}

} // namespace qm

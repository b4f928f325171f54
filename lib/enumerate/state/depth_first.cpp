#include "enumerate/state/depth_first.h"

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// One open decision: the variable was set in; out is still to be tried.
struct Branch {
    int variable;
    std::size_t next; ///< where the search for the next free variable goes on
    SearchState::Mark mark;
};

} // namespace

std::vector<int> branchingOrder(const Problem& problem) {
    std::vector<std::vector<int>> crossingsOf(at(problem.variables()));
    const auto arcs = [&](int crossing) {
        const auto& [a, b] = problem.crossings[at(crossing)].sides;
        return std::array{a.before, a.after, b.before, b.after};
    };
    for (int c = 0; c < static_cast<int>(problem.crossings.size()); ++c)
        for (const int arc : arcs(c))
            if (arc < problem.variables()) crossingsOf[at(arc)].push_back(c);
    std::vector<int> order;
    std::vector<bool> seen(at(problem.variables()), false);
    const auto append = [&](int variable) {
        if (variable >= problem.variables() || seen[at(variable)]) return;
        seen[at(variable)] = true;
        order.push_back(variable);
    };
    for (int start = 0; start < problem.variables(); ++start) {
        std::size_t next = order.size();
        append(start);
        for (; next < order.size(); ++next)
            for (const int crossing : crossingsOf[at(order[next])])
                for (const int arc : arcs(crossing))
                    append(arc);
    }
    return order;
}

bool forEachAssignment(const Problem& problem, const std::function<double()>& costLimit,
                       const std::function<bool(const SearchState&)>& visit, const Control& control) {
    SearchState state(problem);
    if (!state.consistent()) return true;
    const std::vector<int> order = branchingOrder(problem);
    std::vector<Branch> branches;
    bool possible = true;
    std::size_t steps = 0;
    for (std::size_t next = 0;;) {
        if (++steps % 1024 == 0 && control.stopRequested()) return false;
        // Invariant: every assignment that is not consistent with the trail has been visited or cannot be
        // valid, or lies behind an open branch.
        if (possible && state.bound() <= costLimit()) {
            while (next < order.size() && !state.isFree(order[next]))
                ++next;
            if (next < order.size()) {
                branches.push_back({order[next], next, state.mark()});
                possible = state.assign(order[next], ArcState::in);
                continue;
            }
            if (!visit(state)) return false;
        }
        if (branches.empty()) return true;
        const Branch branch = branches.back();
        branches.pop_back();
        state.undo(branch.mark);
        next = branch.next;
        possible = state.assign(branch.variable, ArcState::out);
    }
}

} // namespace qm

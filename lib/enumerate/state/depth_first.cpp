#include "enumerate/state/depth_first.h"

namespace qm {
namespace {

/// A decision whose second side is not yet explored: the variable has been set to in; out remains.
struct Branch {
    VariableId variable;
    std::size_t next; ///< the position in the order from which to look for the next free variable
    SearchState::Mark mark;
};

/// The order of decisions: breadth first over the crossings, starting at the first variable of every
/// connected part, so that decisions that affect each other are close together and contradictions show early.
std::vector<VariableId> branchingOrder(const SearchState& state) {
    const Problem& problem = state.problem();
    std::vector<VariableId> order;
    IdVector<VariableId, bool> seen(problem.arcs.size(), false);
    const auto append = [&](VariableId variable) {
        if (problem.isConstant(variable) || seen[variable]) return;
        seen[variable] = true;
        order.push_back(variable);
    };
    for (const VariableId start : problem.variables()) {
        std::size_t next = order.size();
        append(start);
        for (; next < order.size(); ++next)
            for (const CrossingId crossing : state.crossingsOf(order[next]))
                for (const VariableId arc : problem.crossings[crossing].arcs())
                    append(arc);
    }
    return order;
}

} // namespace

bool forEachAssignment(const Problem& problem, const std::function<double()>& costLimit,
                       const std::function<bool(const SearchState&)>& visit, const Control& control) {
    SearchState state(problem);
    if (!state.consistent()) return true;
    const std::vector<VariableId> order = branchingOrder(state);
    std::vector<Branch> branches;
    bool possible = true;
    std::size_t steps = 0;
    for (std::size_t next = 0;;) {
        if (++steps % 1024 == 0 && control.stopRequested()) return false;
        // Invariant: every assignment that contradicts the trail has been visited, is not valid, or is
        // reached from a branch that is still open.
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

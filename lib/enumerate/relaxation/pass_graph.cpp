#include "enumerate/relaxation/pass_graph.h"

namespace qm {

PassGraph::PassGraph(const SearchState& state, const Formulation& formulation) {
    const Problem& problem = state.problem();
    SparseIdVector<VariableId, SideId> behind; // the side behind each variable
    for (const CrossingId id : formulation.plainCrossings)
        for (const CrossingSide& side : problem.crossings[id].sides) {
            const Formulation::Columns before = formulation.columnsOf[side.before],
                                       after = formulation.columnsOf[side.after];
            behind.at(side.before) = sides_.nextId();
            sides_.push_back({{before.fromBefore, after.fromAfter},
                              {after.fromBefore, before.fromAfter},
                              {},
                              side.before});
        }
    for (const SideId id : sides_.ids()) {
        const VariableId next = sides_[id].before + 1;
        if (!behind[next].valid() || state.chainOf(next) != state.chainOf(next - 1)) continue;
        sides_[id].next[0] = behind[next];
        sides_[behind[next]].next[1] = id;
    }
}

} // namespace qm

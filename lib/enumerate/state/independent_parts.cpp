#include "enumerate/state/independent_parts.h"

#include "base/sparse_disjoint_sets.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace qm {
namespace {

/// Union-find over variables and, as further members, crack nodes, because lines that share head-on meetings
/// belong together.
class Groups {
public:
    explicit Groups(const SearchState& state) : state_(state), problem_(state.problem()) {}

    void joinRulesOf(VariableId variable) {
        if (problem_.gaps) joinChain(state_.chainOf(variable));
        joinCrossings(state_.crossingsOf(variable));
    }

    int find(int member) { return sets_.find(member); }

private:
    [[nodiscard]] int member(CrackNodeId node) const {
        return problem_.domains.nextId().value() + state_.cracks().group(node).value();
    }

    /// Joins a member of a series with the one before it.
    /// \param last  the one before, negative if there is none; becomes this one
    void tie(int& last, int next) {
        if (last >= 0) sets_.join(last, next);
        last = next;
    }

    void joinChain(ChainId id) {
        if (!chains_.insert(id).second) return;
        const Chain& chain = problem_.chains[id];
        const CrackNodeId node = state_.cracks().nodeOfChain(id);
        int last = node.valid() ? member(node) : -1;
        if (node.valid()) joinCrossings(state_.cracks().crossingsOfNode(node));
        for (const VariableId v : chain.variables())
            if (state_.isFree(v)) tie(last, v.value());
    }

    void joinCrossings(const std::vector<CrossingId>& crossings) {
        for (const CrossingId crossing : crossings)
            if (crossings_.insert(crossing).second) joinCrossing(problem_.crossings[crossing]);
    }

    void joinCrossing(const Crossing& crossing) {
        const std::array arcs = crossing.arcs();
        // If one arc is out, the two tracks do not cross, and only rule 2 ties the free variables.
        const bool mayCross = problem_.gaps && std::ranges::none_of(arcs, [&](VariableId arc) {
                                  return state_.value(arc) == ArcState::out;
                              });
        int last = -1;
        for (const VariableId arc : arcs)
            if (state_.isFree(arc)) tie(last, arc.value());
        if (!mayCross) return;
        for (const CrossingSide& side : crossing.sides)
            if (side.node.valid()) tie(last, member(side.node));
    }

    const SearchState& state_;
    const Problem& problem_;
    SparseDisjointSets sets_;
    std::unordered_set<CrossingId> crossings_;
    std::unordered_set<ChainId> chains_;
};

} // namespace

std::vector<std::vector<VariableId>> independentParts(const SearchState& state,
                                                      const std::vector<VariableId>& variables) {
    Groups groups(state);
    for (const VariableId variable : variables)
        groups.joinRulesOf(variable);
    std::vector<std::vector<VariableId>> parts;
    std::unordered_map<int, std::size_t> partOf;
    for (const VariableId variable : variables) {
        if (!state.isFree(variable)) continue;
        const auto [entry, isNew] = partOf.emplace(groups.find(variable.value()), parts.size());
        if (isNew) parts.emplace_back();
        parts[entry->second].push_back(variable);
    }
    return parts;
}

std::vector<std::vector<VariableId>> independentParts(const SearchState& state) {
    const auto variables = state.problem().variables();
    return independentParts(state, {variables.begin(), variables.end()});
}

} // namespace qm

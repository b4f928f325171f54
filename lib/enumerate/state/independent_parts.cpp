#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Union-find over variables and, as further members, crack nodes: lines that share head-on meetings belong
/// together.
class Groups {
public:
    explicit Groups(const SearchState& state) : state_(state), problem_(state.problem()) {}

    void joinRulesOf(int variable) {
        if (problem_.gaps) joinChain(state_.chainOf(variable));
        joinCrossings(state_.crossingsOf(variable));
    }

    int find(int member) {
        int root = member;
        for (auto up = parent_.find(root); up != parent_.end(); up = parent_.find(root))
            root = up->second;
        while (member != root)
            member = std::exchange(parent_[member], root);
        return root;
    }

private:
    void join(int a, int b) {
        const int from = find(a), to = find(b);
        if (from != to) parent_[from] = to;
    }

    [[nodiscard]] bool isFree(int variable) const {
        return variable < problem_.variables() && state_.isFree(variable);
    }

    [[nodiscard]] int member(int node) const {
        return static_cast<int>(problem_.domains.size()) + state_.cracks().group(node);
    }

    void joinChain(int id) {
        if (!chains_.insert(id).second) return;
        const Chain& chain = problem_.chains[at(id)];
        const int node = state_.cracks().nodeOfChain(id);
        int last = node >= 0 ? member(node) : -1;
        if (node >= 0) joinCrossings(state_.cracks().crossingsOfNode(node));
        for (int v = chain.first; v < chain.first + chain.count; ++v) {
            if (!isFree(v)) continue;
            if (last >= 0) join(last, v);
            last = v;
        }
    }

    void joinCrossings(const std::vector<int>& crossings) {
        for (const int crossing : crossings)
            if (crossings_.insert(crossing).second) joinCrossing(problem_.crossings[at(crossing)]);
    }

    void joinCrossing(const Crossing& crossing) {
        const auto& [a, b] = crossing.sides;
        const std::array arcs{a.before, a.after, b.before, b.after};
        // Where one arc is out no two tracks cross, so that only rule 2 ties what is free.
        const bool mayCross = problem_.gaps && std::ranges::none_of(arcs, [&](int arc) {
                                  return state_.value(arc) == ArcState::out;
                              });
        int last = -1;
        const auto tie = [&](int next) {
            if (last >= 0) join(last, next);
            last = next;
        };
        for (const int arc : arcs)
            if (isFree(arc)) tie(arc);
        if (!mayCross) return;
        for (const CrossingSide& side : crossing.sides)
            if (side.node >= 0) tie(member(side.node));
    }

    const SearchState& state_;
    const Problem& problem_;
    std::unordered_map<int, int> parent_;
    std::unordered_set<int> crossings_;
    std::unordered_set<int> chains_;
};

} // namespace

std::vector<std::vector<int>> independentParts(const SearchState& state, const std::vector<int>& variables) {
    Groups groups(state);
    for (const int variable : variables)
        groups.joinRulesOf(variable);
    std::vector<std::vector<int>> parts;
    std::unordered_map<int, std::size_t> partOf;
    for (const int variable : variables) {
        if (!state.isFree(variable)) continue;
        const auto [entry, isNew] = partOf.emplace(groups.find(variable), parts.size());
        if (isNew) parts.emplace_back();
        parts[entry->second].push_back(variable);
    }
    return parts;
}

std::vector<std::vector<int>> independentParts(const SearchState& state) {
    std::vector<int> variables(at(state.problem().variables()));
    std::iota(variables.begin(), variables.end(), 0);
    return independentParts(state, variables);
}

} // namespace qm

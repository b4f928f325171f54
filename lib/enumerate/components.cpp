#include "enumerate/components.h"

#include <algorithm>
#include <numeric>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

class Groups {
public:
    explicit Groups(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int member) {
        while (parent_[at(member)] != member)
            member = parent_[at(member)] = parent_[at(parent_[at(member)])];
        return member;
    }
    void join(int a, int b) { parent_[at(find(a))] = find(b); }

private:
    std::vector<int> parent_;
};

} // namespace

std::vector<std::vector<int>> independentParts(const SearchState& state) {
    const Problem& problem = state.problem();
    const int variables = problem.variables();
    // Crack nodes are members too: lines that share head-on meetings belong together.
    Groups groups(problem.domains.size() + problem.nodes.size());
    const auto nodeMember = [&](int node) { return static_cast<int>(problem.domains.size()) + node; };
    const auto isFree = [&](int variable) { return variable < variables && state.isFree(variable); };
    if (problem.gaps)
        for (const Chain& chain : problem.chains) {
            int last = -1;
            for (int v = chain.first; v < chain.first + chain.count; ++v) {
                if (!isFree(v)) continue;
                if (last >= 0) groups.join(last, v);
                last = v;
            }
        }
    for (std::size_t n = 0; n < problem.nodes.size(); ++n) {
        if (problem.nodes[n].chain < 0) continue;
        const Chain& chain = problem.chains[at(problem.nodes[n].chain)];
        for (int v = chain.first; v < chain.first + chain.count; ++v)
            if (isFree(v)) groups.join(v, nodeMember(static_cast<int>(n)));
    }
    for (const Crossing& crossing : problem.crossings) {
        const std::array arcs{crossing.sides[0].before, crossing.sides[0].after, crossing.sides[1].before,
                              crossing.sides[1].after};
        if (std::ranges::any_of(arcs, [&](int v) { return state.value(v) == ArcState::out; })) {
            // Never a crossing of two tracks: only rule 2 ties what is free.
            int last = -1;
            for (const int v : arcs) {
                if (!isFree(v)) continue;
                if (last >= 0) groups.join(last, v);
                last = v;
            }
            continue;
        }
        int last = -1;
        const auto join = [&](int member) {
            if (last >= 0) groups.join(last, member);
            last = member;
        };
        for (const int v : arcs)
            if (isFree(v)) join(v);
        if (problem.gaps)
            for (const CrossingSide& side : crossing.sides)
                if (side.node >= 0) join(nodeMember(side.node));
    }
    std::vector<std::vector<int>> parts;
    std::vector<int> partOf(problem.domains.size() + problem.nodes.size(), -1);
    for (int v = 0; v < variables; ++v) {
        if (!isFree(v)) continue;
        int& part = partOf[at(groups.find(v))];
        if (part < 0) {
            part = static_cast<int>(parts.size());
            parts.emplace_back();
        }
        parts[at(part)].push_back(v);
    }
    return parts;
}

} // namespace qm

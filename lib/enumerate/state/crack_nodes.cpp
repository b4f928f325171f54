#include "enumerate/state/crack_nodes.h"

#include <numeric>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

class Maker {
public:
    Maker(const ProblemInput& input, const std::vector<Chain>& chains, const std::vector<int>& chainOf)
        : input_(input), graph_(input.graph), chains_(chains), chainOf_(chainOf),
          parent_(graph_.lines.size()), capacity_(graph_.lines.size(), 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
        for (std::size_t line = 0; line < graph_.lines.size(); ++line) {
            crackable_.push_back(findCrackable(LineId(line)));
            if (crackable_.back()) capacity_[line] = 1;
        }
    }

    CrackNodes make() {
        for (const Junction& junction : graph_.junctions)
            joinFixed(junction);
        CrackNodes result;
        result.nodeOf.assign(graph_.lines.size(), -1);
        for (std::size_t line = 0; line < graph_.lines.size(); ++line) {
            if (!crackable_[line]) continue;
            const std::size_t root = find(static_cast<int>(line));
            if (result.nodeOf[root] < 0) {
                result.nodeOf[root] = static_cast<int>(result.nodes.size());
                result.nodes.push_back({chainOf_[root], capacity_[root]});
            }
            result.nodeOf[line] = result.nodeOf[root];
        }
        return result;
    }

private:
    /// Two particles run on it, and everything outside its chain is in.
    [[nodiscard]] bool findCrackable(LineId id) const {
        const Line& line = graph_.lines[id.idx()];
        if (!line.backward) return false;
        const int chain = chainOf_[id.idx()];
        if (chain >= 0) return chains_[at(chain)].coveredBefore && chains_[at(chain)].coveredAfter;
        for (int k = 0; k < line.arcCount; ++k)
            if (input_.states[ArcId(line.firstArc.value() + k).idx()] != ArcState::in) return false;
        return true;
    }

    [[nodiscard]] std::size_t find(int line) const {
        while (parent_[at(line)] != line)
            line = parent_[at(line)];
        return at(line);
    }

    [[nodiscard]] LineId lineOf(ArcId arc) const { return graph_.arcs[arc.idx()].line; }

    void joinFixed(const Junction& junction) {
        if (!junction.crossed()) return;
        for (const ArcId arc : junction.arcs)
            if (!arc.valid() || chainOf_[lineOf(arc).idx()] >= 0 || input_.states[arc.idx()] != ArcState::in)
                return;
        const int a = junction.seeded ? -1 : lineOf(junction.arcs[0]).value();
        const int b = lineOf(junction.arcs[1]).value();
        const bool aFull = a >= 0 && crackable_[at(a)], bFull = crackable_[at(b)];
        if (aFull && bFull && find(a) != find(b)) {
            capacity_[find(b)] += capacity_[find(a)] - 1;
            parent_[find(a)] = static_cast<int>(find(b));
        } else if (aFull || bFull) {
            --capacity_[find(bFull ? b : a)];
        }
    }

    const ProblemInput& input_;
    const ArcGraph& graph_;
    const std::vector<Chain>& chains_;
    const std::vector<int>& chainOf_;
    std::vector<bool> crackable_; ///< of every line
    std::vector<int> parent_;     ///< of joined lines
    std::vector<int> capacity_;   ///< of every root
};

} // namespace

CrackNodes crackNodes(const ProblemInput& input, const std::vector<Chain>& chains,
                      const std::vector<int>& chainOf) {
    return Maker(input, chains, chainOf).make();
}

} // namespace qm

#include "enumerate/state/crack_nodes.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace qm {
namespace {

class Maker {
public:
    Maker(const ProblemInput& input, const IdVector<ChainId, Chain>& chains,
          const SparseIdVector<LineId, ChainId>& chainOf)
        : input_(input), graph_(input.graph), chains_(chains), chainOf_(chainOf) {}

    CrackNodes make(const std::vector<LineId>& lines) {
        std::map<LineId, Group> groups; // keyed by the lowest line, which orders the nodes
        for (const LineId line : lines) {
            if (!isCrackable(line) || !reached_.insert(line).second) continue;
            Group group = joined(line);
            groups[std::ranges::min(group.lines)] = std::move(group);
        }
        CrackNodes result;
        for (const auto& [lowest, group] : groups) {
            for (const LineId line : group.lines)
                result.nodeOf.at(line) = result.nodes.nextId();
            result.nodes.push_back({chainOf_[lowest], group.capacity});
        }
        return result;
    }

private:
    struct Group {
        std::vector<LineId> lines;
        int capacity = 0;
    };

    /// A line can be cracked if particles walk it from both ends and all arcs outside its chain are in.
    [[nodiscard]] bool isCrackable(LineId id) {
        const auto [known, added] = crackable_.try_emplace(id, false);
        if (added) known->second = findCrackable(id);
        return known->second;
    }

    [[nodiscard]] bool findCrackable(LineId id) const {
        const Line& line = graph_.lines[id];
        if (!line.backward) return false;
        const ChainId chain = chainOf_[id];
        if (chain.valid()) return chains_[chain].coveredBefore && chains_[chain].coveredAfter;
        return std::ranges::all_of(line.arcs(),
                                   [&](ArcId arc) { return input_.states[arc] == ArcState::in; });
    }

    [[nodiscard]] LineId lineOf(ArcId arc) const { return graph_.arcs[arc].line; }
    [[nodiscard]] bool isFixed(LineId line) const { return !chainOf_[line].valid(); }

    /// The lines that fixed crossings join to a line, itself included, and the number of cracks that all of
    /// them together have left: one for every line, less one for every crossing.
    Group joined(LineId start) {
        std::vector<LineId> lines{start};
        std::set<JunctionId> crossings;
        for (std::size_t next = 0; next < lines.size(); ++next) {
            if (!isFixed(lines[next])) continue;
            for (const JunctionId junction : junctionsOf(graph_, lines[next]))
                follow(lines[next], junction, lines, crossings);
        }
        return {lines, static_cast<int>(lines.size()) - static_cast<int>(crossings.size())};
    }

    /// Follows a junction from one of its lines to the other. A seed's own line is never cracked at the seed.
    void follow(LineId from, JunctionId id, std::vector<LineId>& lines, std::set<JunctionId>& crossings) {
        const Junction& junction = graph_.junctions[id];
        if (!isFixedCrossing(junction)) return;
        const LineId a = lineOf(junction.arcs[0]), b = lineOf(junction.arcs[1]);
        const bool aFull = !junction.seeded && isCrackable(a), bFull = isCrackable(b);
        if ((from == a && aFull) || (from == b && bFull)) crossings.insert(id);
        if (!aFull || !bFull) return;
        for (const LineId line : {a, b})
            if (reached_.insert(line).second) lines.push_back(line);
    }

    [[nodiscard]] bool isFixedCrossing(const Junction& junction) const {
        return junction.crossed() && std::ranges::all_of(junction.arcs, [&](ArcId arc) {
                   return arc.valid() && isFixed(lineOf(arc)) && input_.states[arc] == ArcState::in;
               });
    }

    const ProblemInput& input_;
    const ArcGraph& graph_;
    const IdVector<ChainId, Chain>& chains_;
    const SparseIdVector<LineId, ChainId>& chainOf_;
    std::unordered_map<LineId, bool> crackable_;
    std::unordered_set<LineId> reached_;
};

} // namespace

CrackNodes crackNodes(const ProblemInput& input, const IdVector<ChainId, Chain>& chains,
                      const SparseIdVector<LineId, ChainId>& chainOf, const std::vector<LineId>& lines) {
    return Maker(input, chains, chainOf).make(lines);
}

} // namespace qm

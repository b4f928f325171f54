#include "layout/meetings.h"

#include <algorithm>
#include <array>
#include <utility>

namespace qm {
namespace {

/// Assigns every crossing to one of its lines such that no line gets two: an orientation of a pseudo-forest
/// (docs/METHOD.md#hakimi-1965).
class Meetings {
public:
    Meetings(const ArcGraph& graph, const std::vector<bool>& present, const Walkers& walkers)
        : graph_(graph), meetingOf_(graph.lines.size()), crossingsOf_(graph.lines.size()) {
        for (std::size_t i = 0; i < graph.lines.size(); ++i) {
            const Line& line = graph.lines[i];
            const auto begin = present.begin() + line.firstArc.value();
            const bool both = line.backward && walkers.fromBegin(LineId(i)) && walkers.fromEnd(LineId(i));
            full_.push_back(both && std::all_of(begin, begin + line.arcCount, [](bool in) { return in; }));
            if (full_.back()) meetingOf_[i] = walkers.meeting(LineId(i));
        }
        for (std::size_t j = 0; j < graph.junctions.size(); ++j)
            if (crossed(graph.junctions[j], present)) addCrossing(JunctionId(j));
    }

    /// For every line the arc after which its particles meet; none if they need not meet.
    std::vector<ArcId> assign() {
        for (std::size_t line = 0; line < crossingsOf_.size(); ++line)
            waiting_.emplace_back(line);
        settleLeaves();
        // Only cycles remain, where both directions are valid.
        for (std::size_t c = 0; c < crossings_.size(); ++c)
            if (!crossings_[c].settled) {
                settle(c, 0);
                settleLeaves();
            }
        return std::move(meetingOf_);
    }

private:
    struct Side {
        LineId line; ///< none if the line cannot be cracked
        ArcId before;
    };
    struct PlusCrossing {
        std::array<Side, 2> sides;
        bool settled = false;
    };

    static bool crossed(const Junction& junction, const std::vector<bool>& present) {
        return std::ranges::all_of(junction.arcs,
                                   [&](ArcId arc) { return arc.valid() && present[arc.idx()]; });
    }

    Side sideOf(const Junction& junction, std::size_t k) const {
        const ArcId before = std::min(junction.arcs[k], junction.arcs[k + 2]);
        const LineId line = graph_.arcs[before.idx()].line;
        const bool crackable = full_[line.idx()] && !junction.isSeedOf(k);
        return {crackable ? line : LineId{}, before};
    }

    void addCrossing(JunctionId id) {
        const Junction& junction = graph_.junctions[id.idx()];
        crossings_.push_back({{sideOf(junction, 0), sideOf(junction, 1)}});
        for (const Side& side : crossings_.back().sides)
            if (side.line.valid()) crossingsOf_[side.line.idx()].push_back(crossings_.size() - 1);
    }

    [[nodiscard]] bool available(const Side& side) const {
        return side.line.valid() && !meetingOf_[side.line.idx()].valid();
    }

    void settle(std::size_t crossing, std::size_t side) {
        PlusCrossing& plus = crossings_[crossing];
        plus.settled = true;
        const Side& chosen = plus.sides[available(plus.sides[side]) ? side : 1 - side];
        if (!available(chosen)) return; // the graph is not valid, which the caller must rule out
        meetingOf_[chosen.line.idx()] = chosen.before;
        for (const std::size_t other : crossingsOf_[chosen.line.idx()])
            for (const Side& neighbour : crossings_[other].sides)
                if (neighbour.line.valid()) waiting_.push_back(neighbour.line);
    }

    /// Assigns every crossing with only one available line to that line, and to every line with only one open
    /// crossing that crossing.
    void settleLeaves() {
        while (!waiting_.empty()) {
            const LineId line = waiting_.back();
            waiting_.pop_back();
            std::size_t open = 0, last = 0;
            for (const std::size_t c : crossingsOf_[line.idx()]) {
                if (crossings_[c].settled) continue;
                const bool first = available(crossings_[c].sides[0]),
                           second = available(crossings_[c].sides[1]);
                const bool self = crossings_[c].sides[0].line == crossings_[c].sides[1].line;
                if (first != second || self) {
                    settle(c, first ? 0 : 1);
                    continue;
                }
                ++open;
                last = c;
            }
            if (open == 1 && !meetingOf_[line.idx()].valid() && !crossings_[last].settled)
                settle(last, crossings_[last].sides[0].line == line ? 0 : 1);
        }
    }

    const ArcGraph& graph_;
    std::vector<bool> full_;
    std::vector<PlusCrossing> crossings_;
    std::vector<ArcId> meetingOf_;
    std::vector<std::vector<std::size_t>> crossingsOf_;
    std::vector<LineId> waiting_;
};

} // namespace

std::vector<ArcId> headOnMeetings(const ArcGraph& graph, const std::vector<bool>& present,
                                  const Walkers& walkers) {
    return Meetings(graph, present, walkers).assign();
}

} // namespace qm

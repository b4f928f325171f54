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
    Meetings(const ArcGraph& graph, const PresentArcs& present, const Walkers& walkers)
        : graph_(graph), meetingOf_(graph.lines.size()), crossingsOf_(graph.lines.size()),
          open_(graph.lines.size()), changed_(graph.lines.size(), true) {
        for (const LineId id : graph.lines.ids()) {
            const Line& line = graph.lines[id];
            const auto begin = present.begin() + line.firstArc.value();
            const bool both = line.backward && walkers.fromBegin(id) && walkers.fromEnd(id);
            full_.push_back(both && std::all_of(begin, begin + line.arcCount, [](bool in) { return in; }));
            if (full_.back()) meetingOf_[id] = walkers.meeting(id);
        }
        for (const Junction& junction : graph.junctions)
            if (crossed(junction, present)) addCrossing(junction);
    }

    /// For every line the arc after which its particles meet; none if they need not meet.
    IdVector<LineId, ArcId> assign() {
        for (const LineId line : crossingsOf_.ids())
            waiting_.push_back(line);
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
    /// The crossings of a line that are not settled. If there is one, the sum is its number.
    struct Open {
        std::size_t count = 0;
        std::size_t sum = 0;
    };

    static bool crossed(const Junction& junction, const PresentArcs& present) {
        return std::ranges::all_of(junction.arcs, [&](ArcId arc) { return arc.valid() && present[arc]; });
    }

    Side sideOf(const Junction& junction, std::size_t k) const {
        const ArcId before = std::min(junction.arcs[k], junction.arcs[k + 2]);
        const LineId line = graph_.arcs[before].line;
        const bool crackable = full_[line] && !junction.isSeedOf(k);
        return {crackable ? line : LineId{}, before};
    }

    void addCrossing(const Junction& junction) {
        crossings_.push_back({{sideOf(junction, 0), sideOf(junction, 1)}});
        for (const Side& side : crossings_.back().sides)
            if (side.line.valid()) {
                crossingsOf_[side.line].push_back(crossings_.size() - 1);
                ++open_[side.line].count;
                open_[side.line].sum += crossings_.size() - 1;
            }
    }

    [[nodiscard]] bool available(const Side& side) const {
        return side.line.valid() && !meetingOf_[side.line].valid();
    }

    void settle(std::size_t crossing, std::size_t side) {
        PlusCrossing& plus = crossings_[crossing];
        plus.settled = true;
        for (const Side& closed : plus.sides)
            if (closed.line.valid()) {
                --open_[closed.line].count;
                open_[closed.line].sum -= crossing;
            }
        const Side& chosen = plus.sides[available(plus.sides[side]) ? side : 1 - side];
        if (!available(chosen)) return; // the graph is not valid, which the caller must rule out
        meetingOf_[chosen.line] = chosen.before;
        for (const std::size_t other : crossingsOf_[chosen.line])
            for (const Side& neighbour : crossings_[other].sides)
                if (neighbour.line.valid()) {
                    waiting_.push_back(neighbour.line);
                    if (!crossings_[other].settled) changed_[neighbour.line] = true;
                }
    }

    /// Assigns every crossing with only one available line to that line, and to every line with only one open
    /// crossing that crossing. The crossings of a line are looked at only if a line has become unavailable at
    /// one of them, so that one line may cross all others.
    void settleLeaves() {
        while (!waiting_.empty()) {
            const LineId line = waiting_.back();
            waiting_.pop_back();
            if (changed_[line]) settleForced(line);
            const auto [count, last] = open_[line];
            if (count == 1 && !meetingOf_[line].valid())
                settle(last, crossings_[last].sides[0].line == line ? 0 : 1);
        }
    }

    void settleForced(LineId line) {
        changed_[line] = false;
        for (const std::size_t c : crossingsOf_[line]) {
            const auto& [sides, settled] = crossings_[c];
            if (settled) continue;
            const bool first = available(sides[0]), second = available(sides[1]);
            if (first != second || sides[0].line == sides[1].line) settle(c, first ? 0 : 1);
        }
    }

    const ArcGraph& graph_;
    IdVector<LineId, bool> full_;
    std::vector<PlusCrossing> crossings_;
    IdVector<LineId, ArcId> meetingOf_;
    IdVector<LineId, std::vector<std::size_t>> crossingsOf_;
    IdVector<LineId, Open> open_;
    IdVector<LineId, bool> changed_; ///< lines at whose open crossings a line may have become unavailable
    std::vector<LineId> waiting_;
};

} // namespace

IdVector<LineId, ArcId> headOnMeetings(const ArcGraph& graph, const PresentArcs& present,
                                       const Walkers& walkers) {
    return Meetings(graph, present, walkers).assign();
}

} // namespace qm

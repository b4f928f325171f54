#include "base/infinity.h"
#include "enumerate/relaxation/cuts.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <utility>

namespace qm {
namespace {

using Tuning = CutTuning;
using SideId = PassGraph::SideId;
using Side = PassGraph::Side;

/// Searches shortest paths in two copies of the graph, one for each parity. A step across a crossing changes
/// the parity; its length is the slack of the crossing's row pass + pass' <= 1. The length of a step along a
/// line is the share of particles that stop between its ends. A path shorter than 1 from a side to its copy
/// yields a violated row.
class OddCycleSearch {
public:
    OddCycleSearch(const PassGraph& graph, const ColumnValues& values)
        : sides_(graph.sides()), values_(values), lengths_(2 * sides_.size(), infinity),
          from_(2 * sides_.size()), isDone_(sides_.size(), false) {}

    std::vector<Formulation::Row> run() {
        std::vector<Formulation::Row> rows;
        std::set<std::vector<ColumnId>> known;
        for (const SideId start : sides_.ids()) {
            if (isDone_[start] || !isOpen(start)) continue;
            if (!findWay(start)) {
                passOver();
                continue;
            }
            Formulation::Row row = rowOf(cycle(start));
            std::vector<ColumnId> columns = row.columns;
            std::ranges::sort(columns);
            if (row.sum(values_) - row.upper > Tuning::minViolation &&
                known.insert(std::move(columns)).second)
                rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    /// A side in one of the two copies: twice its number plus the parity.
    using Place = std::size_t;
    static Place placeOf(SideId side, std::size_t parity) { return 2 * side.idx() + parity; }
    static SideId sideOf(Place place) { return SideId(place / 2); }

    [[nodiscard]] double value(ColumnId column) const { return column.valid() ? values_[column] : 0; }
    [[nodiscard]] double pass(SideId side) const {
        return value(sides_[side].passes[0]) + value(sides_[side].passes[1]);
    }
    [[nodiscard]] bool isOpen(SideId side) const {
        return std::ranges::any_of(sides_[side].passes,
                                   [this](ColumnId column) { return isFractional(value(column)); });
    }
    [[nodiscard]] double slack(SideId side) const {
        return std::max(0.0, 1 - pass(side) - pass(PassGraph::across(side)));
    }
    /// The share of particles that stop between a side and the next one on its line.
    [[nodiscard]] double stops(SideId side, SideId next) const {
        return std::max(0.0, value(sides_[side].passes[0]) - value(sides_[next].passes[0])) +
               std::max(0.0, value(sides_[next].passes[1]) - value(sides_[side].passes[1]));
    }

    /// \return whether a short enough path leads from a side to its copy
    bool findWay(SideId start) {
        for (const Place place : reached_)
            lengths_[place] = infinity;
        reached_.clear();
        using Entry = std::pair<double, Place>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        const auto reach = [&](Place place, double length, Place from) {
            if (length >= lengths_[place] || length > 1 - 2 * Tuning::minViolation) return;
            if (lengths_[place] == infinity) reached_.push_back(place);
            lengths_[place] = length;
            from_[place] = from;
            queue.emplace(length, place);
        };
        const Place source = placeOf(start, 0), target = placeOf(start, 1);
        reach(source, 0, source);
        for (std::size_t looked = 0; !queue.empty() && looked < Tuning::maxPlaces;) {
            const auto [length, place] = queue.top();
            queue.pop();
            if (length > lengths_[place]) continue;
            if (place == target) return true;
            ++looked;
            const SideId side = sideOf(place);
            const std::size_t parity = place % 2;
            reach(placeOf(PassGraph::across(side), 1 - parity), length + slack(side) + Tuning::step, place);
            const auto& [next, previous] = sides_[side].next;
            if (next.valid()) reach(placeOf(next, parity), length + stops(side, next) + Tuning::step, place);
            if (previous.valid())
                reach(placeOf(previous, parity), length + stops(previous, side) + Tuning::step, place);
        }
        return false;
    }

    /// After a search without result, skips all sides close to its start.
    void passOver() {
        for (const Place place : reached_)
            if (lengths_[place] <= Tuning::near) isDone_[sideOf(place)] = true;
    }

    /// The sides of the cycle found last, rotated to begin right after a step across.
    std::vector<SideId> cycle(SideId start) {
        std::vector<SideId> sides;
        for (Place place = placeOf(start, 1); place != placeOf(start, 0); place = from_[place]) {
            sides.push_back(sideOf(place));
            isDone_[sides.back()] = true;
        }
        const auto last =
            std::ranges::adjacent_find(sides, [](SideId a, SideId b) { return PassGraph::across(a) == b; });
        if (last != sides.end()) std::rotate(sides.begin(), std::next(last), sides.end());
        return sides;
    }

    /// The row of a cycle: for every line, the particles that pass both its first and its last crossing.
    [[nodiscard]] Formulation::Row rowOf(const std::vector<SideId>& sides) const {
        Formulation::Row row{{}, {}, -infinity, 0};
        int lines = 0;
        for (std::size_t first = 0; first < sides.size(); ++lines) {
            std::size_t last = first;
            while (last + 1 < sides.size() && PassGraph::across(sides[last]) != sides[last + 1])
                ++last;
            const bool forward = sides_[sides[first]].before <= sides_[sides[last]].before;
            const Side& low = sides_[sides[forward ? first : last]];
            const Side& high = sides_[sides[forward ? last : first]];
            if (high.passes[0].valid()) row.add(high.passes[0], 1);
            if (low.passes[1].valid()) row.add(low.passes[1], 1);
            first = last + 1;
        }
        // A line that crosses itself may have been counted twice, which makes the number of lines even.
        if (lines % 2 == 0) return {};
        const int maxPasses = (lines - 1) / 2;
        row.upper = maxPasses;
        return row;
    }

    const IdVector<SideId, Side>& sides_;
    const ColumnValues& values_;
    std::vector<double> lengths_; ///< of every place, the length of the shortest path to it
    std::vector<Place> from_;
    std::vector<Place> reached_;
    IdVector<SideId, bool> isDone_; ///< sides on a cycle that was found, or known to be on none
};

} // namespace

std::vector<Formulation::Row> brokenOddCycles(const PassGraph& graph, const ColumnValues& values) {
    return OddCycleSearch(graph, values).run();
}

} // namespace qm

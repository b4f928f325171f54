#include "enumerate/state/line_rule.h"

#include <algorithm>

namespace qm {

bool LineRule::visit(VariableId variable) {
    const ChainId id = assignment_.chainOf(variable);
    const Chain& chain = problem_.chains[id];
    const ArcState state = assignment_.value(variable);
    if (chain.coveredBefore && chain.coveredAfter) {
        const Gap& gap = gaps_[id];
        if (state == ArcState::out) {
            if (!openGap(id, variable)) return false;
        } else if (!gap.empty()) {
            if (!spread(chain, variable, variable < gap.first ? -1 : 1)) return false;
        }
    } else {
        const bool towardsBegin = chain.coveredBefore == (state == ArcState::in);
        if (!spread(chain, variable, towardsBegin ? -1 : 1)) return false;
    }
    return !promised_[id] || assignment_.inCount(id) != chain.count;
}

/// For a chain covered from one side: all variables between that side and a variable that is in are in; all
/// beyond a variable that is out are out. Beside a gap, all beyond a variable that is in are in.
///
/// A variable on the way that has the value already goes on from there when its own turn comes.
bool LineRule::spread(const Chain& chain, VariableId variable, int step) {
    const ArcState state = assignment_.value(variable);
    for (VariableId v = variable + step; chain.has(v); v = v + step) {
        if (assignment_.value(v) == state) break;
        if (!assignment_.set(v, state)) return false;
    }
    return true;
}

/// For a chain covered from both sides: extends the gap to a variable that is out, with everything between.
bool LineRule::openGap(ChainId id, VariableId variable) {
    const Chain& chain = problem_.chains[id];
    Gap& gap = gaps_[id];
    const Gap before = gap;
    if (!gap.empty() && variable >= gap.first && variable <= gap.last) return true;
    gapTrail_.push_back({id, before});
    if (!before.empty()) {
        gap = {std::min(before.first, variable), std::max(before.last, variable)};
        const IdRange added = variable < before.first ? IdRange(variable, before.first)
                                                      : IdRange(before.last + 1, variable + 1);
        return std::ranges::all_of(added, [&](VariableId v) { return assignment_.set(v, ArcState::out); });
    }
    gap = {variable, variable};
    for (const int step : {-1, 1}) {
        VariableId v = variable + step;
        while (chain.has(v) && assignment_.value(v) != ArcState::in)
            v = v + step;
        for (; chain.has(v); v = v + step) // those that are in were visited before there was a gap
            if (!assignment_.set(v, ArcState::in)) return false;
    }
    return true;
}

bool LineRule::cover(ChainId id) {
    return std::ranges::all_of(problem_.chains[id].variables(),
                               [&](VariableId v) { return assignment_.set(v, ArcState::in); });
}

void LineRule::undo(const Mark& mark) {
    while (gapTrail_.size() > mark.gaps) {
        gaps_[gapTrail_.back().chain] = gapTrail_.back().before;
        gapTrail_.pop_back();
    }
    promised_.undo(mark.promises);
}

} // namespace qm

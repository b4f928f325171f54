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
    const bool first = before.empty();
    gap = first ? Gap{variable, variable}
                : Gap{std::min(before.first, variable), std::max(before.last, variable)};
    const IdRange added = first                     ? IdRange(variable, variable + 1)
                          : variable < before.first ? IdRange(variable, before.first)
                                                    : IdRange(before.last + 1, variable + 1);
    for (const VariableId v : added)
        if (!assignment_.set(v, ArcState::out)) return false;
    if (!first) return true;
    for (const int step : {-1, 1}) {
        bool seenIn = false;
        for (VariableId v = variable + step; chain.has(v); v = v + step) {
            seenIn = seenIn || assignment_.value(v) == ArcState::in;
            if (seenIn && !assignment_.set(v, ArcState::in)) return false;
        }
    }
    return true;
}

bool LineRule::cover(ChainId id) {
    const Chain& chain = problem_.chains[id];
    for (const VariableId v : chain.variables())
        if (!assignment_.set(v, ArcState::in)) return false;
    return true;
}

void LineRule::undo(const Mark& mark) {
    while (gapTrail_.size() > mark.gaps) {
        gaps_[gapTrail_.back().chain] = gapTrail_.back().before;
        gapTrail_.pop_back();
    }
    promised_.undo(mark.promises);
}

} // namespace qm

#include "enumerate/state/line_rule.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

bool LineRule::visit(int variable) {
    const int id = assignment_.chainOf(variable);
    const Chain& chain = problem_.chains[at(id)];
    const ArcState state = assignment_.value(variable);
    if (chain.coveredBefore && chain.coveredAfter) {
        const Hull& hull = hulls_[at(id)];
        if (state == ArcState::out) {
            if (!openGap(id, variable)) return false;
        } else if (hull.first <= hull.last) {
            const int step = variable < hull.first ? -1 : 1;
            for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step)
                if (!assignment_.set(v, ArcState::in)) return false;
        }
    } else if (!closeOneSided(chain, variable, state)) {
        return false;
    }
    return !promised_[at(id)] || assignment_.inCount(id) != chain.count;
}

/// Covered from one side: the arcs that are in reach back to that side, those that are out go on to the
/// other.
bool LineRule::closeOneSided(const Chain& chain, int variable, ArcState state) {
    const bool towardsBegin = chain.coveredBefore == (state == ArcState::in);
    const int step = towardsBegin ? -1 : 1;
    for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step) {
        if (assignment_.value(v) == state) break;
        if (!assignment_.set(v, state)) return false;
    }
    return true;
}

/// Covered from both sides: the variables that are out form one gap.
bool LineRule::openGap(int id, int variable) {
    const Chain& chain = problem_.chains[at(id)];
    Hull& hull = hulls_[at(id)];
    const Hull before = hull;
    if (hull.first <= hull.last && variable >= hull.first && variable <= hull.last) return true;
    hullTrail_.push_back({id, before});
    const bool first = before.first > before.last;
    hull = first ? Hull{variable, variable}
                 : Hull{std::min(before.first, variable), std::max(before.last, variable)};
    for (int v = hull.first; v <= hull.last; ++v)
        if (!assignment_.set(v, ArcState::out)) return false;
    if (!first) return true;
    for (const int step : {-1, 1}) {
        bool seenIn = false;
        for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step) {
            seenIn = seenIn || assignment_.value(v) == ArcState::in;
            if (seenIn && !assignment_.set(v, ArcState::in)) return false;
        }
    }
    return true;
}

bool LineRule::cover(int id) {
    const Chain& chain = problem_.chains[at(id)];
    for (int v = chain.first; v < chain.first + chain.count; ++v)
        if (!assignment_.set(v, ArcState::in)) return false;
    return true;
}

void LineRule::promiseGap(int chain) {
    if (!promised_[at(chain)]) promiseTrail_.push_back(chain);
    promised_[at(chain)] = true;
}

void LineRule::undo(const Mark& mark) {
    while (hullTrail_.size() > mark.hulls) {
        hulls_[at(hullTrail_.back().chain)] = hullTrail_.back().before;
        hullTrail_.pop_back();
    }
    while (promiseTrail_.size() > mark.promises) {
        promised_[at(promiseTrail_.back())] = false;
        promiseTrail_.pop_back();
    }
}

} // namespace qm

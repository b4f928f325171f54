// Rule 3 of method 2: where a line may be out.
#include "enumerate/state/search_state.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

bool SearchState::visitChain(int variable) {
    const int id = chainOf_[at(variable)];
    const Chain& chain = problem_.chains[at(id)];
    const ArcState state = value(variable);
    if (chain.coveredBefore && chain.coveredAfter) {
        const Hull& hull = hulls_[at(id)];
        if (state == ArcState::out) {
            if (!openGap(id, variable)) return false;
        } else if (hull.first <= hull.last) {
            const int step = variable < hull.first ? -1 : 1;
            for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step)
                if (!set(v, ArcState::in)) return false;
        }
    } else if (!closeOneSided(chain, variable, state)) {
        return false;
    }
    if (promised_[at(id)] && inCount_[at(id)] == chain.count) return false;
    const int node = nodeOfChain_[at(id)];
    if (node < 0) return true;
    const bool decided = state == ArcState::out || inCount_[at(id)] == chain.count;
    return !decided || nodeDecided(node);
}

/// Covered from one side: what is in reaches back to that side, what is out goes on to the other.
bool SearchState::closeOneSided(const Chain& chain, int variable, ArcState state) {
    const bool towardsBegin = chain.coveredBefore == (state == ArcState::in);
    const int step = towardsBegin ? -1 : 1;
    for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step) {
        if (value(v) == state) break;
        if (!set(v, state)) return false;
    }
    return true;
}

/// Covered from both sides: the variables that are out form one gap.
bool SearchState::openGap(int id, int variable) {
    const Chain& chain = problem_.chains[at(id)];
    Hull& hull = hulls_[at(id)];
    const Hull before = hull;
    if (hull.first <= hull.last && variable >= hull.first && variable <= hull.last) return true;
    hullTrail_.push_back({id, before});
    const bool first = before.first > before.last;
    hull = first ? Hull{variable, variable}
                 : Hull{std::min(before.first, variable), std::max(before.last, variable)};
    for (int v = hull.first; v <= hull.last; ++v)
        if (!set(v, ArcState::out)) return false;
    if (!first) return true;
    for (const int step : {-1, 1}) {
        bool seenIn = false;
        for (int v = variable + step; v >= chain.first && v < chain.first + chain.count; v += step) {
            seenIn = seenIn || value(v) == ArcState::in;
            if (seenIn && !set(v, ArcState::in)) return false;
        }
    }
    return true;
}

} // namespace qm

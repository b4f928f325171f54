// Rule 4 of method 2: which lines are covered from end to end, and which crossings they crack.
#include "enumerate/state/junction_rule.h"
#include "enumerate/state/search_state.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

bool SearchState::decideCover(int chain, bool full) {
    if (full) return coverChain(chain) && propagate();
    if (coverOfChain(chain) == Cover::full) return false;
    if (!promised_[at(chain)]) promiseTrail_.push_back(chain);
    promised_[at(chain)] = true;
    const int node = nodeOfChain_[at(chain)];
    return (node < 0 || nodeDecided(node)) && propagate();
}

SearchState::Cover SearchState::coverOf(int node) const {
    const int chain = problem_.nodes[at(node)].chain;
    return chain < 0 ? Cover::full : coverOfChain(chain);
}

SearchState::Cover SearchState::coverOfChain(int chain) const {
    if (hasGap(chain) || promised_[at(chain)]) return Cover::gapped;
    return inCount_[at(chain)] == problem_.chains[at(chain)].count ? Cover::full : Cover::open;
}

bool SearchState::isCrossed(int crossing) const {
    return std::ranges::all_of(arcsOf(problem_.crossings[at(crossing)]),
                               [this](int arc) { return value(arc) == ArcState::in; });
}

bool SearchState::mayBeCrossed(int crossing) const {
    return std::ranges::none_of(arcsOf(problem_.crossings[at(crossing)]),
                                [this](int arc) { return value(arc) == ArcState::out; });
}

/// Enters a crossing into the crack forest as soon as both lines are known to be full or gapped.
bool SearchState::countCrossing(int id) {
    if (counted_[at(id)]) return true;
    if (!isCrossed(id)) return true;
    const Crossing& crossing = problem_.crossings[at(id)];
    std::array<Cover, 2> cover{};
    for (const std::size_t k : {0U, 1U})
        cover[k] = crossing.sides[k].node < 0 ? Cover::gapped : coverOf(crossing.sides[k].node);
    for (const std::size_t k : {0U, 1U})
        if (cover[k] == Cover::gapped) {
            if (cover[1 - k] == Cover::gapped) return false;
            if (cover[1 - k] == Cover::open)
                return coverChain(problem_.nodes[at(crossing.sides[1 - k].node)].chain);
        }
    if (cover[0] == Cover::open || cover[1] == Cover::open) return true;
    counted_[at(id)] = true;
    countedTrail_.push_back(id);
    const int a = crossing.sides[cover[0] == Cover::full ? 0 : 1].node;
    const int b = crossing.sides[cover[1] == Cover::full ? 1 : 0].node;
    return cracks_.cross(a, b);
}

bool SearchState::nodeDecided(int node) {
    return std::ranges::all_of(crossingsOfNode_[at(node)],
                               [this](int crossing) { return countCrossing(crossing); });
}

/// Only a line that is covered from end to end can crack a crossing with a gapped one.
bool SearchState::coverChain(int id) {
    const Chain& chain = problem_.chains[at(id)];
    for (int v = chain.first; v < chain.first + chain.count; ++v)
        if (!set(v, ArcState::in)) return false;
    return true;
}

} // namespace qm

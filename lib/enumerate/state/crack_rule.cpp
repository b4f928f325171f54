#include "enumerate/state/crack_rule.h"

#include <algorithm>

namespace qm {
namespace {

IdVector<CrackNodeId, int> capacities(const Problem& problem) {
    IdVector<CrackNodeId, int> result;
    for (const CrackNode& node : problem.nodes)
        result.push_back(node.capacity);
    return result;
}

} // namespace

CrackRule::CrackRule(const Problem& problem, const PartialAssignment& assignment, LineRule& lines)
    : problem_(problem), assignment_(assignment), lines_(lines), nodeOfChain_(problem.chains.size()),
      crossingsOfNode_(problem.nodes.size()), counted_(problem.crossings.size(), false),
      visited_(problem.nodes.size(), false), forest_(capacities(problem)) {
    for (const CrackNodeId node : problem.nodes.ids())
        if (problem.nodes[node].chain.valid()) nodeOfChain_[problem.nodes[node].chain] = node;
    for (const CrossingId crossing : problem.crossings.ids())
        for (const CrossingSide& side : problem.crossings[crossing].sides)
            if (side.node.valid()) crossingsOfNode_[side.node].push_back(crossing);
}

Cover CrackRule::coverOf(CrackNodeId node) const {
    const ChainId chain = problem_.nodes[node].chain;
    return chain.valid() ? lines_.coverOf(chain) : Cover::full;
}

bool CrackRule::isCrossed(CrossingId crossing) const {
    return std::ranges::all_of(problem_.crossings[crossing].arcs(),
                               [this](VariableId arc) { return assignment_.value(arc) == ArcState::in; });
}

bool CrackRule::mayBeCrossed(CrossingId crossing) const {
    return std::ranges::none_of(problem_.crossings[crossing].arcs(),
                                [this](VariableId arc) { return assignment_.value(arc) == ArcState::out; });
}

/// A crossing with a gapped line can be cracked by its other line only, and only if that is covered.
bool CrackRule::visitCrossing(CrossingId id) {
    if (!isPending(id)) return true;
    const Crossing& crossing = problem_.crossings[id];
    std::array<Cover, 2> cover{};
    for (const std::size_t k : {0U, 1U})
        cover[k] = crossing.sides[k].node.valid() ? coverOf(crossing.sides[k].node) : Cover::gapped;
    for (const std::size_t k : {0U, 1U})
        if (cover[k] == Cover::gapped) {
            if (cover[1 - k] == Cover::gapped) return false;
            if (cover[1 - k] == Cover::open)
                return lines_.cover(problem_.nodes[crossing.sides[1 - k].node].chain);
        }
    if (cover[0] == Cover::open || cover[1] == Cover::open) return true;
    counted_.give(id, true);
    const CrackNodeId a = crossing.sides[cover[0] == Cover::full ? 0 : 1].node;
    const CrackNodeId b = crossing.sides[cover[1] == Cover::full ? 1 : 0].node;
    return forest_.cross(a, b);
}

bool CrackRule::visitCovered(ChainId chain) {
    const CrackNodeId node = nodeOfChain_[chain];
    if (!node.valid() || !visited_.give(node, true)) return true;
    return std::ranges::all_of(crossingsOfNode_[node],
                               [this](CrossingId crossing) { return visitCrossing(crossing); });
}

void CrackRule::undo(const Mark& mark) {
    counted_.undo(mark.counted);
    visited_.undo(mark.visited);
    forest_.undo(mark.changes);
}

} // namespace qm

#include "enumerate/state/crack_rule.h"

#include "enumerate/state/junction_rule.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

std::vector<int> capacities(const Problem& problem) {
    std::vector<int> result;
    for (const CrackNode& node : problem.nodes)
        result.push_back(node.capacity);
    return result;
}

} // namespace

CrackRule::CrackRule(const Problem& problem, const PartialAssignment& assignment, LineRule& lines)
    : problem_(problem), assignment_(assignment), lines_(lines), nodeOfChain_(problem.chains.size(), -1),
      crossingsOfNode_(problem.nodes.size()), counted_(problem.crossings.size(), false),
      forest_(capacities(problem)) {
    for (std::size_t n = 0; n < problem.nodes.size(); ++n)
        if (problem.nodes[n].chain >= 0) nodeOfChain_[at(problem.nodes[n].chain)] = static_cast<int>(n);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c)
        for (const CrossingSide& side : problem.crossings[c].sides)
            if (side.node >= 0) crossingsOfNode_[at(side.node)].push_back(static_cast<int>(c));
}

Cover CrackRule::coverOf(int node) const {
    const int chain = problem_.nodes[at(node)].chain;
    return chain < 0 ? Cover::full : lines_.coverOf(chain);
}

bool CrackRule::isCrossed(int crossing) const {
    return std::ranges::all_of(arcsOf(problem_.crossings[at(crossing)]),
                               [this](int arc) { return assignment_.value(arc) == ArcState::in; });
}

bool CrackRule::mayBeCrossed(int crossing) const {
    return std::ranges::none_of(arcsOf(problem_.crossings[at(crossing)]),
                                [this](int arc) { return assignment_.value(arc) == ArcState::out; });
}

/// Only a line that is covered from end to end can crack a crossing with a gapped one.
bool CrackRule::visitCrossing(int id) {
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
                return lines_.cover(problem_.nodes[at(crossing.sides[1 - k].node)].chain);
        }
    if (cover[0] == Cover::open || cover[1] == Cover::open) return true;
    counted_[at(id)] = true;
    countedTrail_.push_back(id);
    const int a = crossing.sides[cover[0] == Cover::full ? 0 : 1].node;
    const int b = crossing.sides[cover[1] == Cover::full ? 1 : 0].node;
    return forest_.cross(a, b);
}

bool CrackRule::visitCovered(int chain) {
    const int node = nodeOfChain_[at(chain)];
    return node < 0 || std::ranges::all_of(crossingsOfNode_[at(node)],
                                           [this](int crossing) { return visitCrossing(crossing); });
}

void CrackRule::undo(const Mark& mark) {
    while (countedTrail_.size() > mark.counted) {
        counted_[at(countedTrail_.back())] = false;
        countedTrail_.pop_back();
    }
    forest_.undo(mark.changes);
}

} // namespace qm

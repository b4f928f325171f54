#include "enumerate/diagram/border.h"

#include "base/at.h"
#include "base/sort_unique.h"

#include <algorithm>

namespace qm {
namespace {

constexpr unsigned valueBits = 2;
constexpr unsigned groupBits = 16; ///< for a group's label, and again for the number of its meetings left
constexpr unsigned wordBits = 64;

/// The first and the last step that concern something, such as a crossing or a chain.
struct Span {
    int first = -1;
    int last = -1;
    void add(int step) {
        if (step < 0) return;
        first = first < 0 ? step : std::min(first, step);
        last = std::max(last, step);
    }
    /// Adds `id` to the watches of all steps before which it is decided in part.
    template <class Watches, class Key, class Pick> void watch(Watches& watches, Key id, Pick pick) const {
        for (int step = first + 1; first >= 0 && step <= last; ++step)
            (watches[at(step)].*pick).push_back(id);
    }
};

class Packer {
public:
    explicit Packer(std::uint64_t* words) : words_(words) {}
    void put(std::uint64_t value, unsigned bits) {
        if (used_ + bits > wordBits) {
            ++words_;
            used_ = 0;
        }
        if (used_ == 0) *words_ = 0;
        *words_ |= value << used_;
        used_ += bits;
    }

private:
    std::uint64_t* words_;
    unsigned used_ = 0;
};

std::size_t wordsFor(std::size_t values, std::size_t groups) {
    // Values fill whole words before the first group begins; the two numbers of a group share a word.
    const std::size_t valuesPerWord = wordBits / valueBits, groupsPerWord = wordBits / (2 * groupBits);
    return (values + valuesPerWord - 1) / valuesPerWord + (groups + groupsPerWord - 1) / groupsPerWord;
}

} // namespace

DiagramBorder::DiagramBorder(const SearchState& state, const std::vector<Step>& steps)
    : watches_(steps.size()), labelOf_(state.problem().nodes.size(), 0) {
    const Problem& problem = state.problem();
    IdVector<VariableId, int> stepOf(problem.domains.size(), -1);
    IdVector<ChainId, Span> chains(problem.chains.size());
    IdVector<CrossingId, Span> crossings(problem.crossings.size());
    IdVector<CrackNodeId, Span> nodes(problem.nodes.size());
    for (int k = 0; k < static_cast<int>(steps.size()); ++k) {
        const Step& step = steps[at(k)];
        if (!step.variable.valid()) {
            crossings[step.crossing].add(k);
            chains[step.chain].add(k);
            continue;
        }
        stepOf[step.variable] = k;
        if (problem.gaps) chains[state.chainOf(step.variable)].add(k);
        for (const CrossingId crossing : state.crossingsOf(step.variable))
            crossings[crossing].add(k);
    }
    for (const ChainId id : problem.chains.ids()) {
        if (!problem.gaps) break;
        const Chain& chain = problem.chains[id];
        for (const VariableId v : chain.variables())
            if (stepOf[v] >= 0) Span{chains[id].first, stepOf[v]}.watch(watches_, v, &Watch::variables);
        if (chain.coveredBefore && chain.coveredAfter) chains[id].watch(watches_, id, &Watch::chains);
    }
    for (const CrossingId c : crossings.ids()) {
        lastStep_.push_back(crossings[c].last);
        for (const CrossingSide& side : problem.crossings[c].sides) {
            for (const VariableId variable : {side.before, side.after})
                if (stepOf[variable] >= 0) crossings[c].watch(watches_, variable, &Watch::variables);
            if (!problem.gaps || !side.node.valid()) continue;
            nodes[side.node].add(crossings[c].first);
            nodes[side.node].add(crossings[c].last);
        }
    }
    for (const CrackNodeId node : nodes.ids())
        nodes[node].watch(watches_, node, &Watch::nodes);
    for (Watch& watch : watches_) {
        sortUnique(watch.variables);
        watch.words = wordsFor(watch.variables.size() + watch.chains.size(), watch.nodes.size());
    }
}

bool DiagramBorder::canCrack(const SearchState& state, std::size_t step, CrackNodeId node) const {
    const ChainId chain = state.problem().nodes[node].chain;
    if (chain.valid() && state.coverOfChain(chain) != Cover::full) return false;
    const bool left = state.cracks().left(state.cracks().group(node)) > 0;
    return std::ranges::any_of(state.cracks().crossingsOfNode(node), [&](CrossingId crossing) {
        return lastStep_[crossing] >= static_cast<int>(step) &&
               (left ? state.cracks().mayBeCrossed(crossing) : state.cracks().isPending(crossing));
    });
}

/// A covered chain that can crack nothing has the same code as a chain with a gap, so that such states meet.
std::uint64_t DiagramBorder::coverCode(const SearchState& state, std::size_t step, ChainId chain) const {
    enum Code { open, covered, toHaveGap, done };
    if (state.hasGap(chain)) return done;
    const CrackNodeId node = state.cracks().nodeOfChain(chain);
    switch (state.coverOfChain(chain)) {
    case Cover::open:
        return open;
    case Cover::gapped:
        return toHaveGap;
    default:
        return node.valid() && canCrack(state, step, node) ? covered : done;
    }
}

void DiagramBorder::describe(const SearchState& state, std::size_t step, std::uint64_t* words) {
    const Watch& watch = watches_[step];
    Packer values(words);
    for (const VariableId variable : watch.variables)
        values.put(static_cast<std::uint64_t>(state.value(variable)) & 3, valueBits);
    for (const ChainId chain : watch.chains)
        values.put(coverCode(state, step, chain), valueBits);
    Packer groups(words + wordsFor(watch.variables.size() + watch.chains.size(), 0));
    std::uint16_t labels = 0;
    for (const CrackNodeId node : watch.nodes) {
        if (!canCrack(state, step, node)) {
            groups.put(0, 2 * groupBits);
            continue;
        }
        const CrackNodeId group = state.cracks().group(node);
        const int left = state.cracks().left(group);
        // Groups that have no meeting left are all alike, and have no label.
        if (left > 0 && labelOf_[group] == 0) labelOf_[group] = ++labels;
        groups.put(labelOf_[group], groupBits);
        groups.put(static_cast<std::uint64_t>(left) + 1, groupBits);
    }
    for (const CrackNodeId node : watch.nodes)
        labelOf_[state.cracks().group(node)] = 0;
}

} // namespace qm

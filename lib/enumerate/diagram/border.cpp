#include "enumerate/diagram/border.h"

#include <algorithm>

namespace qm {
namespace {

constexpr unsigned valueBits = 2;
constexpr unsigned groupBits = 16; ///< of a group's label, and as many of what it has left
constexpr unsigned wordBits = 64;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// The first and last of the steps that something depends on.
struct Span {
    int first = -1;
    int last = -1;
    void add(int step) {
        if (step < 0) return;
        first = first < 0 ? step : std::min(first, step);
        last = std::max(last, step);
    }
    /// The steps at which it is decided in part.
    template <class Watches, class Pick> void watch(Watches& watches, int id, Pick pick) const {
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
    // Values fill whole words before the first group begins; a group's two numbers never straddle words.
    const std::size_t valuesPerWord = wordBits / valueBits, groupsPerWord = wordBits / (2 * groupBits);
    return (values + valuesPerWord - 1) / valuesPerWord + (groups + groupsPerWord - 1) / groupsPerWord;
}

} // namespace

DiagramBorder::DiagramBorder(const SearchState& state, const std::vector<Step>& steps)
    : watches_(steps.size()), labelOf_(state.problem().nodes.size(), 0) {
    const Problem& problem = state.problem();
    std::vector<int> stepOf(problem.domains.size(), -1);
    std::vector<Span> chains(problem.chains.size()), crossings(problem.crossings.size()),
        nodes(problem.nodes.size());
    for (int k = 0; k < static_cast<int>(steps.size()); ++k) {
        const Step& step = steps[at(k)];
        if (step.variable < 0) {
            crossings[at(step.crossing)].add(k);
            chains[at(step.chain)].add(k);
            continue;
        }
        stepOf[at(step.variable)] = k;
        if (problem.gaps) chains[at(state.chainOf(step.variable))].add(k);
        for (const int crossing : state.crossingsOf(step.variable))
            crossings[at(crossing)].add(k);
    }
    const auto watchVariable = [&](int variable, int from, int to) {
        for (int step = from; step <= to; ++step)
            watches_[at(step)].variables.push_back(variable);
    };
    for (std::size_t c = 0; problem.gaps && c < problem.chains.size(); ++c) {
        const Chain& chain = problem.chains[c];
        for (int v = chain.first; v < chain.first + chain.count; ++v)
            if (stepOf[at(v)] >= 0) watchVariable(v, chains[c].first + 1, stepOf[at(v)]);
        if (chain.coveredBefore && chain.coveredAfter)
            chains[c].watch(watches_, static_cast<int>(c), &Watch::chains);
    }
    for (std::size_t c = 0; c < crossings.size(); ++c) {
        lastStep_.push_back(crossings[c].last);
        for (const CrossingSide& side : problem.crossings[c].sides) {
            for (const int variable : {side.before, side.after})
                if (stepOf[at(variable)] >= 0)
                    watchVariable(variable, crossings[c].first + 1, crossings[c].last);
            if (!problem.gaps || side.node < 0) continue;
            nodes[at(side.node)].add(crossings[c].first);
            nodes[at(side.node)].add(crossings[c].last);
        }
    }
    for (std::size_t node = 0; node < nodes.size(); ++node)
        nodes[node].watch(watches_, static_cast<int>(node), &Watch::nodes);
    for (Watch& watch : watches_) {
        std::ranges::sort(watch.variables);
        watch.variables.erase(std::unique(watch.variables.begin(), watch.variables.end()),
                              watch.variables.end());
        watch.words = wordsFor(watch.variables.size() + watch.chains.size(), watch.nodes.size());
    }
}

bool DiagramBorder::canCrack(const SearchState& state, std::size_t step, int node) const {
    const int chain = state.problem().nodes[at(node)].chain;
    if (chain >= 0 && state.coverOfChain(chain) != Cover::full) return false;
    const bool left = state.cracks().left(state.cracks().group(node)) > 0;
    return std::ranges::any_of(state.cracks().crossingsOfNode(node), [&](int crossing) {
        return lastStep_[at(crossing)] >= static_cast<int>(step) &&
               (left ? state.cracks().mayBeCrossed(crossing) : state.cracks().isPending(crossing));
    });
}

/// A chain that is covered but can crack nothing is as good as one with a gap behind.
std::uint64_t DiagramBorder::coverCode(const SearchState& state, std::size_t step, int chain) const {
    enum Code { open, covered, toHaveGap, done };
    if (state.hasGap(chain)) return done;
    const int node = state.cracks().nodeOfChain(chain);
    switch (state.coverOfChain(chain)) {
    case Cover::open:
        return open;
    case Cover::gapped:
        return toHaveGap;
    default:
        return node >= 0 && canCrack(state, step, node) ? covered : done;
    }
}

void DiagramBorder::describe(const SearchState& state, std::size_t step, std::uint64_t* words) {
    const Watch& watch = watches_[step];
    Packer values(words);
    for (const int variable : watch.variables)
        values.put(static_cast<std::uint64_t>(state.value(variable)) & 3, valueBits);
    for (const int chain : watch.chains)
        values.put(coverCode(state, step, chain), valueBits);
    Packer groups(words + wordsFor(watch.variables.size() + watch.chains.size(), 0));
    std::uint16_t labels = 0;
    for (const int node : watch.nodes) {
        if (!canCrack(state, step, node)) {
            groups.put(0, 2 * groupBits);
            continue;
        }
        const int group = state.cracks().group(node);
        const int left = state.cracks().left(group);
        // Groups that have nothing left are all alike.
        if (left > 0 && labelOf_[at(group)] == 0) labelOf_[at(group)] = ++labels;
        groups.put(labelOf_[at(group)], groupBits);
        groups.put(static_cast<std::uint64_t>(left) + 1, groupBits);
    }
    for (const int node : watch.nodes)
        labelOf_[at(state.cracks().group(node))] = 0;
}

} // namespace qm

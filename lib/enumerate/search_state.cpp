#include "enumerate/search_state.h"

#include <algorithm>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// What rule 2 concludes from the four arcs around a junction: bit k of a mask stands for arc k in the order
/// before and after of side 0, before and after of side 1.
struct Conclusion {
    unsigned forcedIn = 0;
    unsigned forcedOut = 0;
    bool possible = false;
};

constexpr bool allowedPattern(unsigned pattern) {
    const bool a0 = pattern & 1, a1 = pattern & 2, b0 = pattern & 4, b1 = pattern & 8;
    return (a0 == a1 || (b0 && b1)) && (b0 == b1 || (a0 && a1));
}

/// Indexed by the four states in base 3: out, in, free.
constexpr auto makeConclusions() {
    std::array<Conclusion, 81> table{};
    for (unsigned index = 0; index < 81; ++index) {
        unsigned all = 15, any = 0;
        for (unsigned pattern = 0; pattern < 16; ++pattern) {
            bool fits = allowedPattern(pattern);
            for (unsigned k = 0, rest = index; k < 4; ++k, rest /= 3)
                fits = fits && (rest % 3 == 2 || rest % 3 == ((pattern >> k) & 1));
            if (!fits) continue;
            table[index].possible = true;
            all &= pattern;
            any |= pattern;
        }
        table[index].forcedIn = all;
        table[index].forcedOut = ~any & 15;
    }
    return table;
}
constexpr auto conclusions = makeConclusions();

std::vector<int> capacities(const Problem& problem) {
    std::vector<int> result;
    for (const CrackNode& node : problem.nodes)
        result.push_back(node.capacity);
    return result;
}

std::array<int, 4> arcsOf(const Crossing& crossing) {
    const auto& [a, b] = crossing.sides;
    return {a.before, a.after, b.before, b.after};
}

} // namespace

SearchState::SearchState(const Problem& problem)
    : problem_(problem), values_(problem.domains.size(), ArcState::free),
      chainOf_(problem.domains.size(), -1), crossingsOf_(problem.domains.size()),
      nodeOfChain_(problem.chains.size(), -1), crossingsOfNode_(problem.nodes.size()),
      hulls_(problem.chains.size()), inCount_(problem.chains.size(), 0),
      promised_(problem.chains.size(), false), counted_(problem.crossings.size(), false),
      cracks_(capacities(problem)), free_(static_cast<int>(problem.domains.size())) {
    for (const double cost : problem.costs)
        bound_ += std::min(cost, 0.0);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c) {
        bound_ += cornerBound(static_cast<int>(c));
        cornersCost_ = cornersCost_ || problem.crossings[c].cornerCost != 0;
    }
    for (std::size_t c = 0; c < problem.chains.size(); ++c)
        for (int k = 0; k < problem.chains[c].count; ++k)
            chainOf_[at(problem.chains[c].first + k)] = static_cast<int>(c);
    for (std::size_t n = 0; n < problem.nodes.size(); ++n)
        if (problem.nodes[n].chain >= 0) nodeOfChain_[at(problem.nodes[n].chain)] = static_cast<int>(n);
    for (std::size_t c = 0; c < problem.crossings.size(); ++c) {
        for (const int arc : arcsOf(problem.crossings[c]))
            if (crossingsOf_[at(arc)].empty() || crossingsOf_[at(arc)].back() != static_cast<int>(c))
                crossingsOf_[at(arc)].push_back(static_cast<int>(c));
        for (const CrossingSide& side : problem.crossings[c].sides)
            if (side.node >= 0) crossingsOfNode_[at(side.node)].push_back(static_cast<int>(c));
    }
    for (std::size_t v = 0; v < problem.domains.size(); ++v)
        if (problem.domains[v] != ArcState::free)
            consistent_ = consistent_ && set(static_cast<int>(v), problem.domains[v]);
    consistent_ = consistent_ && propagate();
}

SearchState::Mark SearchState::mark() const {
    return {assigned_.size(),  hullTrail_.size(),    countedTrail_.size(),
            cracks_.changes(), promiseTrail_.size(), bound_};
}

void SearchState::undo(const Mark& mark) {
    while (assigned_.size() > mark.assignments) {
        const int variable = assigned_.back();
        assigned_.pop_back();
        const int chain = chainOf_[at(variable)];
        if (chain >= 0 && value(variable) == ArcState::in) --inCount_[at(chain)];
        values_[at(variable)] = ArcState::free;
        ++free_;
    }
    while (hullTrail_.size() > mark.hulls) {
        hulls_[at(hullTrail_.back().chain)] = hullTrail_.back().before;
        hullTrail_.pop_back();
    }
    while (countedTrail_.size() > mark.counted) {
        counted_[at(countedTrail_.back())] = false;
        countedTrail_.pop_back();
    }
    cracks_.undo(mark.cracks);
    while (promiseTrail_.size() > mark.promises) {
        promised_[at(promiseTrail_.back())] = false;
        promiseTrail_.pop_back();
    }
    propagated_ = assigned_.size();
    bound_ = mark.bound;
}

bool SearchState::assign(int variable, ArcState value) {
    return set(variable, value) && propagate();
}

bool SearchState::decideCover(int chain, bool full) {
    if (full) return coverChain(chain) && propagate();
    if (coverOfChain(chain) == Cover::full) return false;
    if (!promised_[at(chain)]) promiseTrail_.push_back(chain);
    promised_[at(chain)] = true;
    const int node = nodeOfChain_[at(chain)];
    return (node < 0 || nodeDecided(node)) && propagate();
}

bool SearchState::set(int variable, ArcState value) {
    ArcState& current = values_[at(variable)];
    if (current != ArcState::free) return current == value;
    const double cornersBefore = cornersCost_ ? cornerBounds(variable) : 0;
    current = value;
    assigned_.push_back(variable);
    --free_;
    if (cornersCost_) bound_ += cornerBounds(variable) - cornersBefore;
    const double cost = problem_.costs[at(variable)];
    bound_ += value == ArcState::in ? std::max(cost, 0.0) : -std::min(cost, 0.0);
    if (value == ArcState::in && chainOf_[at(variable)] >= 0) ++inCount_[at(chainOf_[at(variable)])];
    return true;
}

double SearchState::cornerBound(int id) const {
    const Crossing& crossing = problem_.crossings[at(id)];
    const auto arcs = [&](const CrossingSide& side) {
        const auto counts = [&](int arc) {
            return crossing.cornerCost < 0 ? value(arc) != ArcState::out : value(arc) == ArcState::in;
        };
        return (counts(side.before) ? 1 : 0) + (counts(side.after) ? 1 : 0);
    };
    return crossing.cornerCost * cornersAt(arcs(crossing.sides[0]), arcs(crossing.sides[1]));
}

double SearchState::cornerBounds(int variable) const {
    double sum = 0;
    for (const int crossing : crossingsOf_[at(variable)])
        sum += cornerBound(crossing);
    return sum;
}

bool SearchState::propagate() {
    while (propagated_ < assigned_.size()) {
        const int variable = assigned_[propagated_++];
        if (problem_.gaps && chainOf_[at(variable)] >= 0 && !visitChain(variable)) return false;
        for (const int crossing : crossingsOf_[at(variable)])
            if (!visitCrossing(crossing)) return false;
    }
    return true;
}

bool SearchState::visitCrossing(int id) {
    return (problem_.crossings[at(id)].open || applyRule2(id)) && (!problem_.gaps || countCrossing(id));
}

bool SearchState::applyRule2(int id) {
    const std::array<int, 4> arcs = arcsOf(problem_.crossings[at(id)]);
    unsigned index = 0;
    for (int k = 3; k >= 0; --k) {
        const ArcState state = value(arcs[at(k)]);
        index = index * 3 + (state == ArcState::free ? 2U : static_cast<unsigned>(state));
    }
    const Conclusion& conclusion = conclusions[index];
    if (!conclusion.possible) return false;
    for (unsigned k = 0; k < 4; ++k) {
        if ((conclusion.forcedIn >> k & 1) && !set(arcs[k], ArcState::in)) return false;
        if ((conclusion.forcedOut >> k & 1) && !set(arcs[k], ArcState::out)) return false;
    }
    return true;
}

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

std::vector<int> SearchState::assignedSince(const Mark& mark) const {
    return {assigned_.begin() + static_cast<std::ptrdiff_t>(mark.assignments), assigned_.end()};
}

Assignment SearchState::assignment() const {
    Assignment result;
    result.reserve(values_.size());
    for (const ArcState state : values_)
        result.push_back(state == ArcState::in ? 1 : 0);
    return result;
}

} // namespace qm

#include "enumerate/branch_and_bound.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double integral = 1e-6; ///< closer to 0 or 1 than this is taken for it
constexpr int reliable = 4;       ///< probes after which a pseudo-cost is trusted
constexpr std::size_t probesPerNode = 8;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

BranchAndBound::BranchAndBound(SearchState& state, std::vector<int> variables, std::size_t best,
                               double maxCost, double gap, const Control& control)
    : state_(state), variables_(std::move(variables)), relaxation_(state, variables_),
      incumbents_(best, maxCost), best_(best), gap_(gap), control_(control),
      growthIn_(state.problem().costs.size()), growthOut_(state.problem().costs.size()), root_(state.mark()) {
}

void BranchAndBound::offer(const Assignment& assignment) {
    double cost = 0;
    for (const int variable : variables_)
        if (assignment[at(variable)] == 1) cost += state_.problem().costs[at(variable)];
    incumbents_.offer(cost, assignment);
}

void BranchAndBound::run() {
    open(-1, {}, -infinity);
    while (!queue_.empty()) {
        const OpenNode next = queue_.top();
        if (next.bound >= incumbents_.cutoff() - (best_ == 1 ? gap_ : 0)) break;
        if (control_.stopRequested()) {
            complete_ = false;
            break;
        }
        queue_.pop();
        if (replay(next.node)) plunge(next.node);
    }
    state_.undo(root_);
    lowerBound_ = queue_.empty() ? infinity : queue_.top().bound;
    if (!incumbents_.empty()) lowerBound_ = std::min(lowerBound_, incumbents_.bestCost());
}

int BranchAndBound::open(int parent, Decision decision, double bound) {
    tree_.push_back({parent, decision, bound});
    const int node = static_cast<int>(tree_.size()) - 1;
    queue_.push({bound, node});
    return node;
}

bool BranchAndBound::take(const Decision& decision) {
    path_.push_back(decision);
    if (decision.about == Decision::About::value) return state_.assign(decision.variable, decision.state);
    return decision.state == ArcState::out || state_.assign(decision.variable, ArcState::in);
}

/// Brings the state to an open node.
bool BranchAndBound::replay(int node) {
    state_.undo(root_);
    path_.clear();
    std::vector<int> path;
    for (int n = node; tree_[at(n)].parent >= 0; n = tree_[at(n)].parent)
        path.push_back(n);
    return std::all_of(path.rbegin(), path.rend(), [this](int n) { return take(tree_[at(n)].decision); });
}

/// Goes down from a node, to the better side each time, and leaves the other sides open.
void BranchAndBound::plunge(int node) {
    double inherited = tree_[at(node)].bound;
    for (;;) {
        ++nodes_;
        if (control_.stopRequested()) {
            queue_.push({inherited, node});
            return;
        }
        const auto bound = relaxation_.solve(state_, path_, incumbents_.cutoff());
        if (!bound || !fixByReducedCosts(*bound)) return;
        if (acceptIntegral() && best_ == 1) return;
        dive();
        if (*bound >= incumbents_.cutoff()) return;
        relaxation_.solve(state_, path_, infinity); // probing below needs the values of this node again
        const Choice choice = choose(*bound);
        if (choice.decision.variable < 0) return;
        Decision first = choice.decision, second = choice.decision;
        first.state = choice.boundIn <= choice.boundOut ? ArcState::in : ArcState::out;
        second.state = first.state == ArcState::in ? ArcState::out : ArcState::in;
        const double firstBound = std::min(choice.boundIn, choice.boundOut);
        const double secondBound = std::max(choice.boundIn, choice.boundOut);
        if (secondBound < incumbents_.cutoff()) open(node, second, std::max(*bound, secondBound));
        if (firstBound >= incumbents_.cutoff()) return;
        inherited = std::max(*bound, firstBound);
        tree_.push_back({node, first, inherited});
        node = static_cast<int>(tree_.size()) - 1;
        if (!take(first)) return;
    }
}

bool BranchAndBound::fixByReducedCosts(double bound) {
    if (incumbents_.cutoff() == infinity) return true;
    for (const auto& [variable, value] : relaxation_.fixings(bound, incumbents_.cutoff()))
        if (state_.value(variable) != value && !(state_.isFree(variable) && state_.assign(variable, value)))
            return false;
    return true;
}

double BranchAndBound::partCost() const {
    double cost = 0;
    for (const int variable : variables_)
        if (state_.value(variable) == ArcState::in) cost += state_.problem().costs[at(variable)];
    return cost;
}

void BranchAndBound::recordLeaf() {
    incumbents_.offer(partCost(), state_.assignment());
}

/// Takes the relaxed solution if it is integral and obeys all rules.
bool BranchAndBound::acceptIntegral() {
    for (const int variable : variables_) {
        const double value = relaxation_.value(variable);
        if (value > integral && value < 1 - integral) return false;
    }
    const SearchState::Mark mark = state_.mark();
    bool valid = true;
    for (const int variable : variables_)
        valid = valid &&
                (!state_.isFree(variable) ||
                 state_.assign(variable, relaxation_.value(variable) > 0.5 ? ArcState::in : ArcState::out));
    if (valid) recordLeaf();
    state_.undo(mark);
    return valid;
}

/// Rounds the relaxed solution, the surest values first, following every conclusion.
void BranchAndBound::dive() {
    std::vector<std::pair<double, int>> order;
    for (const int variable : variables_)
        if (state_.isFree(variable)) {
            const double value = relaxation_.value(variable);
            order.emplace_back(std::min(value, 1 - value), variable);
        }
    std::ranges::sort(order);
    const SearchState::Mark mark = state_.mark();
    bool valid = true;
    for (const auto& [doubt, variable] : order) {
        if (!state_.isFree(variable)) continue;
        const bool up = relaxation_.value(variable) > 0.5;
        const SearchState::Mark before = state_.mark();
        if (state_.assign(variable, up ? ArcState::in : ArcState::out)) continue;
        state_.undo(before);
        valid = state_.assign(variable, up ? ArcState::out : ArcState::in);
        if (!valid) break;
    }
    if (valid) recordLeaf();
    state_.undo(mark);
}

double BranchAndBound::score(int variable) const {
    const double value = relaxation_.value(variable);
    const auto estimate = [&](const PseudoCost& cost, double distance) {
        const double mean =
            cost.count > 0 ? cost.sum / cost.count : std::abs(state_.problem().costs[at(variable)]) + 1;
        return std::max(mean * distance, 1e-6);
    };
    return estimate(growthIn_[at(variable)], 1 - value) * estimate(growthOut_[at(variable)], value);
}

BranchAndBound::Choice BranchAndBound::choose(double bound) {
    std::vector<std::pair<double, int>> candidates;
    int anyFree = -1;
    for (const int variable : variables_) {
        if (!state_.isFree(variable)) continue;
        const double value = relaxation_.value(variable);
        if (anyFree < 0) anyFree = variable;
        if (value > integral && value < 1 - integral) candidates.emplace_back(-score(variable), variable);
    }
    if (candidates.empty()) {
        if (const auto walk = relaxation_.undecidedWalk()) return {*walk, bound, bound};
        return {{anyFree, Decision::About::value, ArcState::free}, bound, bound};
    }
    std::ranges::sort(candidates);
    const auto undecided = [](int variable) {
        return Decision{variable, Decision::About::value, ArcState::free};
    };
    Choice best{undecided(candidates.front().second), bound, bound};
    double bestScore = -1;
    std::size_t probes = 0;
    std::vector<std::pair<int, double>> values;
    for (const auto& [negativeScore, variable] : candidates) {
        const bool trusted =
            std::min(growthIn_[at(variable)].count, growthOut_[at(variable)].count) >= reliable;
        if (trusted && -negativeScore > bestScore) {
            bestScore = -negativeScore;
            best = {undecided(variable), bound, bound};
        }
        if (trusted || probes == probesPerNode) continue;
        ++probes;
        const Choice choice = probe(variable, bound);
        if (choice.boundIn == infinity || choice.boundOut == infinity) return choice;
        const double found = std::max(choice.boundIn - bound, 1e-6) * std::max(choice.boundOut - bound, 1e-6);
        if (found > bestScore) {
            bestScore = found;
            best = choice;
        }
    }
    return best;
}

BranchAndBound::Choice BranchAndBound::probe(int variable, double bound) {
    const double value = relaxation_.value(variable);
    Choice choice{{variable, Decision::About::value, ArcState::free}, infinity, infinity};
    if (const auto in = probeSide(variable, ArcState::in)) {
        choice.boundIn = *in;
        learn(variable, ArcState::in, (*in - bound) / std::max(1 - value, integral));
    }
    if (const auto out = probeSide(variable, ArcState::out)) {
        choice.boundOut = *out;
        learn(variable, ArcState::out, (*out - bound) / std::max(value, integral));
    }
    return choice;
}

std::optional<double> BranchAndBound::probeSide(int variable, ArcState value) {
    const SearchState::Mark mark = state_.mark();
    std::optional<double> bound;
    if (state_.assign(variable, value)) bound = relaxation_.solve(state_, path_, incumbents_.cutoff());
    state_.undo(mark);
    return bound;
}

void BranchAndBound::learn(int variable, ArcState value, double growth) {
    PseudoCost& cost = (value == ArcState::in ? growthIn_ : growthOut_)[at(variable)];
    cost.sum += std::max(growth, 0.0);
    ++cost.count;
}

} // namespace qm

#include "enumerate/optimum/branch_and_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int iterationsPerSlice = 2000; ///< between questions whether to stop
constexpr int mostSlices = 10000;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

BranchAndBound::BranchAndBound(SearchState& state, std::vector<int> variables, const PartOptions& options,
                               const Control& control)
    : state_(state), origin_(state.mark()), variables_(std::move(variables)), cost_(state, variables_),
      options_(options), control_(control), incumbents_(options.best, options.maxCost),
      formulation_(formulate(state, variables_)), particles_(state, formulation_),
      relaxation_(formulation_, particles_), pseudoCosts_(formulation_.costs), root_(particles_.mark()) {}

void BranchAndBound::offer(const Assignment& assignment) {
    incumbents_.offer(cost_.of([&](int variable) { return assignment[at(variable)] == 1; }), assignment);
}

void BranchAndBound::run() {
    if (particles_.consistent()) {
        queue_.push({cost_.atLeast(state_), addNode(-1, {})});
        guess();
        search();
    }
    lowerBound_ = queue_.empty() ? options_.maxCost : queue_.top().bound;
    if (!incumbents_.empty()) lowerBound_ = std::min(lowerBound_, incumbents_.bestCost());
}

void BranchAndBound::search() {
    while (!queue_.empty()) {
        const OpenNode next = queue_.top();
        if (next.bound >= incumbents_.cutoff() - (options_.best == 1 ? options_.gap : 0)) break;
        if (control_.stopRequested() || tree_.size() > options_.nodes) {
            complete_ = false;
            break;
        }
        queue_.pop();
        if (!tightenRoot())
            queue_ = {};
        else if (replay(next.node))
            plunge(next.node, next.bound);
    }
}

int BranchAndBound::addNode(int parent, const Decision& decision) {
    tree_.push_back({parent, decision});
    return static_cast<int>(tree_.size()) - 1;
}

void BranchAndBound::open(int parent, const Decision& decision, double bound) {
    queue_.push({bound, addNode(parent, decision)});
}

/// Brings the state to an open node.
bool BranchAndBound::replay(int node) {
    particles_.undo(root_);
    std::vector<int> path;
    for (int n = node; tree_[at(n)].parent >= 0; n = tree_[at(n)].parent)
        path.push_back(n);
    return std::all_of(path.rbegin(), path.rend(),
                       [this](int n) { return particles_.take(tree_[at(n)].decision); });
}

/// Goes down from a node, to the better side each time, and leaves the other sides open.
void BranchAndBound::plunge(int node, double bound) {
    for (;;) {
        ++nodes_;
        const bool isRoot = tree_[at(node)].parent < 0;
        const RelaxedNode relaxed = relax(bound);
        if (relaxed == RelaxedNode::cut) return;
        if (control_.stopRequested()) {
            queue_.push({bound, node});
            return;
        }
        if (allDecided()) return recordLeaf();
        if (relaxed == RelaxedNode::solved) {
            if (isRoot) rememberRoot(bound);
            if (acceptIntegral() && options_.best == 1) return;
            round();
            if (nodes_ >= nextLook_ && !lookAround(bound)) return;
            if (allDecided()) return recordLeaf();
        }
        const Choice choice = relaxed == RelaxedNode::solved ? choose(bound) : chooseAnyFree(bound);
        Decision first = choice.decision, second = choice.decision;
        first.state = choice.boundIn <= choice.boundOut ? ArcState::in : ArcState::out;
        second.state = first.state == ArcState::in ? ArcState::out : ArcState::in;
        const double firstBound = std::min(choice.boundIn, choice.boundOut);
        const double secondBound = std::max(choice.boundIn, choice.boundOut);
        if (secondBound < incumbents_.cutoff()) open(node, second, secondBound);
        if (firstBound >= incumbents_.cutoff()) return;
        // The root's lesser problem is not known before both sides are.
        if (isRoot) return open(node, first, firstBound);
        bound = firstBound;
        node = addNode(node, first);
        if (!particles_.take(first)) return;
    }
}

/// Solves the relaxation, and again while fixing by reduced costs has consequences. `bound` grows.
BranchAndBound::RelaxedNode BranchAndBound::relax(double& bound) {
    for (;;) {
        Relaxation::Result result;
        for (int slice = 0; slice < mostSlices; ++slice) {
            result = relaxation_.solve(particles_, incumbents_.cutoff(), iterationsPerSlice);
            bound = std::max(bound, result.proven);
            if (result.kind != Relaxation::Result::Kind::unfinished || control_.stopRequested()) break;
        }
        if (result.kind == Relaxation::Result::Kind::tooExpensive) return RelaxedNode::cut;
        if (result.kind == Relaxation::Result::Kind::unfinished) return RelaxedNode::unfinished;
        bound = std::max(bound, result.bound);
        if (!fixByReducedCosts(relaxation_.values(), relaxation_.reducedCosts(), result.bound))
            return RelaxedNode::cut;
        if (!contradictsRelaxation()) return RelaxedNode::solved;
    }
}

/// Columns keep their value where every other one makes a graph too expensive.
bool BranchAndBound::fixByReducedCosts(const std::vector<double>& values, const std::vector<double>& reduced,
                                       double bound) {
    const double room = incumbents_.cutoff() - bound;
    if (room == infinity) return true;
    for (int column = 0; column < static_cast<int>(values.size()); ++column) {
        if (particles_.column(column) != ArcState::free || std::abs(reduced[at(column)]) <= room) continue;
        const bool low = values[at(column)]<integral, high = values[at(column)]> 1 - integral;
        if (low && reduced[at(column)] > 0 && !particles_.fixColumn(column, ArcState::out)) return false;
        if (high && reduced[at(column)] < 0 && !particles_.fixColumn(column, ArcState::in)) return false;
    }
    return true;
}

bool BranchAndBound::contradictsRelaxation() const {
    for (int column = 0; column < static_cast<int>(formulation_.costs.size()); ++column) {
        const ArcState known = particles_.column(column);
        const double value = relaxation_.values()[at(column)];
        if ((known == ArcState::in && value < 1 - integral) || (known == ArcState::out && value > integral))
            return true;
    }
    return false;
}

void BranchAndBound::rememberRoot(double bound) {
    rootBound_ = bound;
    rootValues_ = relaxation_.values();
    for (const int variable : variables_)
        rootPresence_.push_back(present(variable));
    rootReducedCosts_ = relaxation_.reducedCosts();
    rootBasis_ = relaxation_.basis();
    rootCutoff_ = incumbents_.cutoff();
    root_ = particles_.mark();
}

/// A better graph lets more be fixed at the root, for good. \return false if nothing cheaper is left
bool BranchAndBound::tightenRoot() {
    if (rootValues_.empty() || incumbents_.cutoff() >= rootCutoff_) return true;
    rootCutoff_ = incumbents_.cutoff();
    particles_.undo(root_);
    if (!fixByReducedCosts(rootValues_, rootReducedCosts_, rootBound_)) return false;
    root_ = particles_.mark();
    if (relaxation_.fixedShare(particles_) > 0.3) {
        relaxation_ = Relaxation(formulation_, particles_);
        rootBasis_ = {};
    }
    return true;
}

std::optional<RelaxedProgram> BranchAndBound::relaxedRoot() {
    if (rootValues_.empty()) return {};
    const double best = incumbents_.empty() ? options_.maxCost : incumbents_.bestCost();
    constexpr int slices = 20; // it was optimal but for what has been fixed since
    Relaxation::Result result{Relaxation::Result::Kind::tooExpensive};
    if (tightenRoot()) {
        particles_.undo(root_);
        relaxation_.setBasis(rootBasis_);
        for (int slice = 0; slice < slices; ++slice) {
            result = relaxation_.solve(particles_, incumbents_.cutoff(), iterationsPerSlice);
            if (result.kind != Relaxation::Result::Kind::unfinished) break;
        }
    }
    if (result.kind == Relaxation::Result::Kind::tooExpensive) {
        lowerBound_ = best;
        complete_ = true;
    }
    if (result.kind != Relaxation::Result::Kind::solved) return {};
    lowerBound_ = std::max(lowerBound_, std::min(result.bound, best));
    RelaxedProgram root = relaxation_.program(particles_);
    root.cutoff = best;
    return root;
}

} // namespace qm

#include "enumerate/optimum/branch_and_bound.h"

#include "enumerate/optimum/early_graphs.h"
#include "enumerate/optimum/node_relaxation.h"
#include "enumerate/optimum/tuning.h"
#include "enumerate/relaxation/cuts.h"

#include <algorithm>

namespace qm {

BranchAndBound::BranchAndBound(SearchState& state, std::vector<VariableId> variables,
                               const PartOptions& options, const Control& control)
    : origin_(state.mark()), part_(state, std::move(variables), options, control), branching_(part_),
      root_(part_) {}

void BranchAndBound::offer(const Assignment& assignment) {
    part_.incumbents.offer(part_.cost.of([&](VariableId variable) { return assignment[variable] == 1; }),
                           assignment);
}

void BranchAndBound::run() {
    if (part_.columns.consistent()) {
        double bound = part_.cost.lowerBound(part_.state);
        complete_ = part_.variables.size() < part_.options.large || relaxNearly(bound);
        tree_.open(tree_.add({}, {}), bound);
        guessGraphs(part_);
        if (complete_) search();
    }
    summarise();
}

/// \return whether to go on to the root
bool BranchAndBound::relaxNearly(double& bound) {
    bound = std::max(bound, root_.relaxNearly());
    if (near_ && !near_(bound)) return false;
    root_.startFromNear();
    return true;
}

void BranchAndBound::resume(std::size_t nodes) {
    part_.options.nodes = nodes;
    complete_ = true;
    search();
    summarise();
}

void BranchAndBound::conclude(const Assignment& best) {
    offer(best);
    tree_.closeAll();
    complete_ = true;
    summarise();
}

void BranchAndBound::summarise() {
    lowerBound_ = tree_.allClosed() ? part_.options.maxCost : tree_.next().bound;
    if (!part_.incumbents.empty()) lowerBound_ = std::min(lowerBound_, part_.incumbents.bestCost());
}

void BranchAndBound::search() {
    while (!tree_.allClosed()) {
        const SearchTree::OpenNode next = tree_.next();
        if (next.bound >= part_.incumbents.cutoff() - (part_.options.best == 1 ? part_.options.gap : 0))
            break;
        if (part_.isOver() || tree_.size() > part_.options.nodes) {
            complete_ = false;
            break;
        }
        tree_.closeNext();
        if (!root_.tighten())
            tree_.closeAll();
        else if (replay(next.node))
            plunge(next.node, next.bound);
    }
}

/// Repeats the decisions that lead to an open node.
bool BranchAndBound::replay(SearchTree::NodeId node) {
    root_.restore();
    return std::ranges::all_of(tree_.path(node),
                               [this](const Decision& decision) { return part_.columns.take(decision); });
}

/// Goes down from a node, to the better side each time, and leaves the other sides open.
void BranchAndBound::plunge(SearchTree::NodeId node, double bound) {
    for (;;) {
        ++nodes_;
        const bool isRoot = tree_.isRoot(node);
        const RelaxedNode relaxed = relaxNode(part_, bound);
        if (relaxed == RelaxedNode::cut) return;
        if (part_.isOver()) {
            tree_.open(node, bound);
            return;
        }
        if (part_.allDecided()) return part_.recordLeaf();
        if (relaxed == RelaxedNode::solved) {
            if (isRoot) root_.remember(bound);
            if (acceptIntegral(part_) && part_.options.best == 1) return;
            roundRelaxed(part_);
            if (nodes_ >= nextLook_ && !lookAround(bound)) return;
            if (isRoot && !cutRoot(bound)) return;
            if (part_.allDecided()) return part_.recordLeaf();
        }
        const BranchingChoice choice =
            relaxed == RelaxedNode::solved ? branching_.choose(bound) : branching_.chooseAnyFree(bound);
        Decision first = choice.decision, second = choice.decision;
        first.state = arcState(choice.boundIn <= choice.boundOut);
        second.state = arcState(choice.boundIn > choice.boundOut);
        const double firstBound = std::min(choice.boundIn, choice.boundOut);
        const double secondBound = std::max(choice.boundIn, choice.boundOut);
        if (secondBound < part_.incumbents.cutoff()) tree_.open(tree_.add(node, second), secondBound);
        if (firstBound >= part_.incumbents.cutoff()) return;
        // Nothing below the root is searched before both of its sides wait in the queue.
        if (isRoot) return tree_.open(tree_.add(node, first), firstBound);
        bound = firstBound;
        node = tree_.add(node, first);
        if (!part_.columns.take(first)) return;
    }
}

/// Adds rows that graphs obey and the relaxed solution breaks, as long as that raises the bound enough; then
/// looks for graphs near the new solution.
/// \return false if the root is cut
bool BranchAndBound::cutRoot(double& bound) {
    if (part_.variables.size() < part_.options.cut) return true;
    // With what the best graph fixes, the relaxation is smaller.
    if (!root_.tighten() || relaxNode(part_, bound) == RelaxedNode::cut) return false;
    const PassGraph graph(part_.state, part_.formulation);
    const auto* price = CutTuning::prices.begin();
    const double uncut = bound;
    for (int round = 0; round < CutTuning::maxRounds && price != CutTuning::prices.end(); ++round) {
        for (const auto& cuts : {brokenTrails(graph, part_.relaxation.values(), *price),
                                 brokenOddCycles(graph, part_.relaxation.values())})
            part_.formulation.rows.insert(part_.formulation.rows.end(), cuts.begin(), cuts.end());
        part_.relaxation.addRows(part_.columns);
        const double before = bound;
        const RelaxedNode relaxed = relaxNode(part_, bound);
        if (relaxed == RelaxedNode::cut) return false;
        if (relaxed == RelaxedNode::unfinished) return true;
        part_.relaxation.dropIdleRows();
        root_.remember(bound);
        if (bound - before < CutTuning::minGain * (part_.incumbents.cutoff() - before)) ++price;
    }
    return bound <= uncut || lookAround(bound);
}

/// Looks for graphs near the relaxed solution, then comes back to it.
/// \return false if the node is cut now
bool BranchAndBound::lookAround(double& bound) {
    nextLook_ = TreeTuning::growthBetweenDives * nodes_;
    const ColumnState::Mark mark = part_.columns.mark();
    const Relaxation::Basis basis = part_.relaxation.basis();
    if (part_.variables.size() < part_.options.hard) {
        dive(part_);
    } else {
        diveToRest(part_);
        polish();
        if (!comeBack(mark, basis, bound)) return false;
        searchNearby(part_);
    }
    return comeBack(mark, basis, bound);
}

/// \return false if the node is cut by what has been found since
bool BranchAndBound::comeBack(ColumnState::Mark mark, const Relaxation::Basis& basis, double& bound) {
    part_.columns.undo(mark);
    part_.relaxation.setBasis(basis);
    return bound < part_.incumbents.cutoff() && relaxNode(part_, bound) != RelaxedNode::cut;
}

void BranchAndBound::polish() {
    if (!polisher_ || root_.presence().empty() || part_.incumbents.empty() ||
        part_.incumbents.bestCost() >= polished_)
        return;
    offer(polisher_(part_.incumbents.graphs().begin()->second, root_.presence()));
    polished_ = part_.incumbents.bestCost();
}

std::optional<RelaxedProgram> BranchAndBound::relaxedRoot() {
    const double best = part_.incumbents.empty() ? part_.options.maxCost : part_.incumbents.bestCost();
    if (!root_.isKnown()) {
        std::optional<RelaxedProgram> near = root_.takeNear();
        if (near) near->cutoff = best;
        return near;
    }
    const Relaxation::Result result = root_.solveAgain();
    if (result.kind == Relaxation::Result::Kind::tooExpensive) {
        lowerBound_ = best;
        complete_ = true;
    }
    if (result.kind != Relaxation::Result::Kind::solved) return {};
    lowerBound_ = std::max(lowerBound_, std::min(result.bound, best));
    RelaxedProgram root = part_.relaxation.program(part_.columns);
    root.cutoff = best;
    return root;
}

} // namespace qm

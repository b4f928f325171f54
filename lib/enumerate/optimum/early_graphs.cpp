#include "enumerate/optimum/branch_and_bound.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

bool BranchAndBound::allDecided() const {
    return std::ranges::none_of(variables_, [this](int variable) { return state_.isFree(variable); });
}

/// A variable's value in the last relaxed solution.
double BranchAndBound::present(int variable) const {
    const auto& [fromBefore, fromAfter] = formulation_.columnsOf[at(variable)];
    const auto value = [this](int column) { return column < 0 ? 0 : relaxation_.values()[at(column)]; };
    return value(fromBefore) + value(fromAfter);
}

void BranchAndBound::recordLeaf() {
    incumbents_.offer(cost_.of([this](int variable) { return state_.value(variable) == ArcState::in; }),
                      state_.assignment());
}

/// Takes the relaxed solution if it is integral and obeys all rules.
bool BranchAndBound::acceptIntegral() {
    for (const int variable : variables_)
        if (isFractional(present(variable))) return false;
    const ParticleState::Mark mark = particles_.mark();
    const bool valid = std::ranges::all_of(variables_, [this](int variable) {
        const ArcState value = present(variable) > 0.5 ? ArcState::in : ArcState::out;
        return state_.isFree(variable) ? state_.assign(variable, value) : state_.value(variable) == value;
    });
    if (valid) recordLeaf();
    particles_.undo(mark);
    return valid;
}

/// Rounds the relaxed solution to the nearer value, and again up: without rule 3 the latter always gives a
/// graph.
void BranchAndBound::round() {
    roundAt(0.5);
    if (!state_.problem().gaps) roundAt(integral);
}

/// A graph without asking the relaxation, however long that may take: as much as fits, or as little.
void BranchAndBound::guess() {
    for (const double threshold : {2.0, -1.0})
        if (particles_.consistent()) roundAt(threshold);
}

/// Everything above the threshold is in, the surest values first, following every conclusion.
void BranchAndBound::roundAt(double threshold) {
    std::vector<std::pair<double, int>> order;
    for (const int variable : variables_)
        if (state_.isFree(variable)) order.emplace_back(-std::abs(present(variable) - threshold), variable);
    std::ranges::sort(order);
    const ParticleState::Mark mark = particles_.mark();
    bool valid = true;
    for (const auto& [doubt, variable] : order) {
        if (!state_.isFree(variable)) continue;
        const bool up = present(variable) > threshold;
        const SearchState::Mark before = state_.mark();
        if (state_.assign(variable, up ? ArcState::in : ArcState::out)) continue;
        state_.undo(before);
        valid = state_.assign(variable, up ? ArcState::out : ArcState::in);
        if (!valid) break;
    }
    if (valid) recordLeaf();
    particles_.undo(mark);
}

/// Looks for graphs near the relaxed solution, then comes back to it. \return false if the node is cut now
bool BranchAndBound::lookAround(double& bound) {
    nextLook_ = 4 * nodes_;
    const ParticleState::Mark mark = particles_.mark();
    const Relaxation::Basis basis = relaxation_.basis();
    if (variables_.size() < options_.hard) {
        dive();
    } else {
        diveToRest();
        polish();
        if (!comeBack(mark, basis, bound)) return false;
        searchNearby();
    }
    return comeBack(mark, basis, bound);
}

/// \return false if the node is cut by what has been found since
bool BranchAndBound::comeBack(ParticleState::Mark mark, const Relaxation::Basis& basis, double& bound) {
    particles_.undo(mark);
    relaxation_.setBasis(basis);
    return bound < incumbents_.cutoff() && relax(bound) != RelaxedNode::cut;
}

void BranchAndBound::polish() {
    if (!options_.polish || rootPresence_.empty() || incumbents_.empty() ||
        incumbents_.bestCost() >= polished_)
        return;
    offer(options_.polish(incumbents_.graphs().begin()->second, rootPresence_));
    polished_ = incumbents_.bestCost();
}

} // namespace qm

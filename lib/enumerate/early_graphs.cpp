#include "enumerate/branch_and_bound.h"
#include "enumerate/independent_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace qm {
namespace {

constexpr double integral = 1e-6;
constexpr double sure = 0.8; ///< columns above this may be fixed together in a dive
constexpr int diveIterations = 1000;
constexpr std::size_t worthSearching = 1500; ///< variables; fewer are searched as fast as what is near them
constexpr std::size_t nodesNearby = 100;
constexpr double infinity = std::numeric_limits<double>::infinity();

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
        if (present(variable) > integral && present(variable) < 1 - integral) return false;
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
    if (options_.nearby && variables_.size() >= worthSearching) {
        if (nodes_ == 1) searchNearby(false);
        if (!incumbents_.empty()) searchNearby(true);
    } else {
        dive();
    }
    particles_.undo(mark);
    relaxation_.setBasis(basis);
    if (bound >= incumbents_.cutoff()) return false;
    return relax(bound) != RelaxedNode::cut;
}

/// Takes over what the relaxed solution leaves no doubt about, or what it and the best graph agree on, and
/// searches the rest.
void BranchAndBound::searchNearby(bool keepBest) {
    const ParticleState::Mark mark = particles_.mark();
    std::size_t open = 0;
    for (const int variable : variables_)
        if (state_.isFree(variable) && !takeOver(variable, keepBest)) ++open;
    if (2 * open < variables_.size() && searchRest(keepBest)) recordLeaf();
    particles_.undo(mark);
}

/// \return whether the variable has a value now
bool BranchAndBound::takeOver(int variable, bool keepBest) {
    const double value = present(variable);
    if (value > integral && value < 1 - integral) return false;
    const bool in = value > 0.5;
    if (keepBest && (incumbents_.graphs().begin()->second[at(variable)] == 1) != in) return false;
    const SearchState::Mark before = state_.mark();
    if (state_.assign(variable, in ? ArcState::in : ArcState::out)) return true;
    state_.undo(before);
    return false;
}

/// Gives the best values to what is still free, part by part. \return false if there are none
bool BranchAndBound::searchRest(bool keepBest) {
    std::vector<int> rest;
    for (const int variable : variables_)
        if (state_.isFree(variable)) rest.push_back(variable);
    for (const std::vector<int>& part : independentParts(state_, rest)) {
        Assignment found;
        {
            BranchAndBound search(state_, part, {1, infinity, 0, nodesNearby, false}, control_);
            if (keepBest) search.offer(incumbents_.graphs().begin()->second);
            search.run();
            if (search.incumbents().empty()) return false;
            found = search.incumbents().graphs().begin()->second;
        }
        for (const int variable : part)
            if (state_.isFree(variable) &&
                !state_.assign(variable, found[at(variable)] == 1 ? ArcState::in : ArcState::out))
                return false;
    }
    return true;
}

/// Fixes the columns that are nearly 1 and solves again, until the solution is integral or too expensive.
void BranchAndBound::dive() {
    while (!control_.stopRequested() && fixSurest()) {
        if (relaxation_.solve(particles_, incumbents_.cutoff(), diveIterations).kind !=
            Relaxation::Result::Kind::solved)
            return;
        if (acceptIntegral()) return;
        round();
    }
}

/// \return false if nothing is left to fix
bool BranchAndBound::fixSurest() {
    std::vector<std::pair<double, int>> order;
    const std::vector<double> values = relaxation_.values();
    for (int column = 0; column < static_cast<int>(values.size()); ++column) {
        const double value = values[at(column)];
        if (value > integral && value < 1 - integral && formulation_.variableOf[at(column)] >= 0 &&
            particles_.column(column) == ArcState::free)
            order.emplace_back(-value, column);
    }
    std::ranges::sort(order);
    const std::size_t most = 1 + order.size() / 10;
    std::size_t fixed = 0;
    for (const auto& [negative, column] : order) {
        if (fixed == most || (fixed > 0 && -negative < sure)) break;
        if (particles_.column(column) != ArcState::free) continue;
        const ParticleState::Mark before = particles_.mark();
        ++fixed;
        if (particles_.fixColumn(column, ArcState::in)) continue;
        particles_.undo(before);
        if (!particles_.fixColumn(column, ArcState::out)) return false;
    }
    return fixed > 0;
}

} // namespace qm

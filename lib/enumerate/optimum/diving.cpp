#include "enumerate/optimum/branch_and_bound.h"
#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <limits>

namespace qm {
namespace {

constexpr double sure = 0.8; ///< columns above this may be fixed together in a dive
constexpr int diveIterations = 1000;
constexpr std::size_t smallRest = 1500; ///< variables that a dive leaves to a search
constexpr std::size_t largeRest = 5000; ///< more take as long as the whole
constexpr std::size_t nodesNearby = 100;
constexpr std::size_t never = std::numeric_limits<std::size_t>::max(); ///< hard: searches do not nest
constexpr double infinity = std::numeric_limits<double>::infinity();

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace

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

/// The same, until what the relaxed solution leaves in doubt is small enough to be searched. Values that the
/// relaxed solution is sure of may contradict each other; then it goes on.
void BranchAndBound::diveToRest() {
    while (!control_.stopRequested()) {
        const ParticleState::Mark mark = particles_.mark();
        const bool found = takeOverAll(false) <= smallRest && searchRest(false);
        if (found) recordLeaf();
        particles_.undo(mark);
        if (found || !fixSurest() ||
            relaxation_.solve(particles_, incumbents_.cutoff(), 4 * diveIterations).kind !=
                Relaxation::Result::Kind::solved)
            return;
    }
}

/// \return false if nothing is left to fix
bool BranchAndBound::fixSurest() {
    std::vector<std::pair<double, int>> order;
    const std::vector<double> values = relaxation_.values();
    for (int column = 0; column < static_cast<int>(values.size()); ++column) {
        const double value = values[at(column)];
        if (isFractional(value) && formulation_.variableOf[at(column)] >= 0 &&
            particles_.column(column) == ArcState::free)
            order.emplace_back(-value, column);
    }
    std::ranges::sort(order);
    const std::size_t most = 1 + order.size() / 10, few = 1 + order.size() / 50;
    std::size_t fixed = 0;
    for (const auto& [negative, column] : order) {
        if (fixed == most || (fixed >= few && -negative < sure)) break;
        if (particles_.column(column) != ArcState::free) continue;
        const ParticleState::Mark before = particles_.mark();
        ++fixed;
        if (particles_.fixColumn(column, ArcState::in)) continue;
        particles_.undo(before);
        if (!particles_.fixColumn(column, ArcState::out)) return false;
    }
    return fixed > 0;
}

/// Searches what the relaxed solution and the best graph do not agree on.
void BranchAndBound::searchNearby() {
    if (incumbents_.empty()) return;
    const ParticleState::Mark mark = particles_.mark();
    const std::size_t open = takeOverAll(true);
    if (open <= largeRest && 2 * open < variables_.size() && searchRest(true)) recordLeaf();
    particles_.undo(mark);
}

/// Takes over what the relaxed solution leaves no doubt about and, on demand, the best graph does not
/// contradict. \return how many variables were in doubt
std::size_t BranchAndBound::takeOverAll(bool keepBest) {
    std::size_t open = 0;
    for (const int variable : variables_)
        if (state_.isFree(variable) && !takeOver(variable, keepBest)) ++open;
    return open;
}

/// \return whether the variable has a value now
bool BranchAndBound::takeOver(int variable, bool keepBest) {
    const double value = present(variable);
    if (isFractional(value)) return false;
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
            BranchAndBound search(state_, part, {1, infinity, 0, nodesNearby, never}, control_);
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

} // namespace qm

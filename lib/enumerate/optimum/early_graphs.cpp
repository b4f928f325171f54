#include "enumerate/optimum/early_graphs.h"

#include "enumerate/optimum/branch_and_bound.h"
#include "enumerate/optimum/tuning.h"
#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

using Tuning = DivingTuning;

/// Sets values above the threshold to in and others to out, the surest first, and draws all conclusions.
void roundAt(PartSearch& part, double threshold) {
    std::vector<std::pair<double, VariableId>> order;
    for (const VariableId variable : part.variables)
        if (part.state.isFree(variable))
            order.emplace_back(-std::abs(part.present(variable) - threshold), variable);
    std::ranges::sort(order);
    const ColumnState::Mark mark = part.columns.mark();
    bool valid = true;
    for (const auto& [doubt, variable] : order) {
        if (!part.state.isFree(variable)) continue;
        const bool up = part.present(variable) > threshold;
        const SearchState::Mark before = part.state.mark();
        if (part.state.assign(variable, arcState(up))) continue;
        part.state.undo(before);
        valid = part.state.assign(variable, arcState(!up));
        if (!valid) break;
    }
    if (valid) part.recordLeaf();
    part.columns.undo(mark);
}

/// Fixes the fractional columns of highest value to 1.
/// \return false if none is left, or on a contradiction
bool fixSurest(PartSearch& part) {
    std::vector<std::pair<double, ColumnId>> order;
    for (const auto& [column, value] : part.fractionalColumns())
        order.emplace_back(-value, column);
    std::ranges::sort(order);
    const std::size_t max = 1 + order.size() / Tuning::maxStep, min = 1 + order.size() / Tuning::minStep;
    std::size_t fixed = 0;
    for (const auto& [negative, column] : order) {
        if (fixed == max || (fixed >= min && -negative < Tuning::sureValue)) break;
        if (part.columns.value(column) != ArcState::free) continue;
        const ColumnState::Mark before = part.columns.mark();
        ++fixed;
        if (part.columns.fixColumn(column, ArcState::in)) continue;
        part.columns.undo(before);
        if (!part.columns.fixColumn(column, ArcState::out)) return false;
    }
    return fixed > 0;
}

/// Which values of the relaxed solution are taken over.
enum class TakenOver {
    integral, ///< all that are
    asInBest  ///< those that are integral and agree with the best graph
};

/// Assigns the relaxed value of a variable if it is one of those.
/// \return whether the variable has a value now
bool takeOver(PartSearch& part, VariableId variable, TakenOver values) {
    const double value = part.present(variable);
    if (isFractional(value)) return false;
    const bool in = value > 0.5;
    if (values == TakenOver::asInBest && (part.incumbents.graphs().begin()->second[variable] == 1) != in)
        return false;
    const SearchState::Mark before = part.state.mark();
    if (part.state.assign(variable, arcState(in))) return true;
    part.state.undo(before);
    return false;
}

/// \return the number of variables that are still free
std::size_t takeOverAll(PartSearch& part, TakenOver values) {
    std::size_t open = 0;
    for (const VariableId variable : part.variables)
        if (part.state.isFree(variable) && !takeOver(part, variable, values)) ++open;
    return open;
}

/// Searches for the best values of all variables that are free, part by part; if others agree with the best
/// graph, it is a graph to begin with.
/// \return false if there are none
bool searchRest(PartSearch& part, TakenOver values) {
    std::vector<VariableId> rest;
    for (const VariableId variable : part.variables)
        if (part.state.isFree(variable)) rest.push_back(variable);
    for (const std::vector<VariableId>& piece : independentParts(part.state, rest)) {
        Assignment found;
        {
            PartOptions options;
            options.nodes = Tuning::nodes;
            options.work = part.options.work - std::min(part.work(), part.options.work);
            options.hard = PartOptions::never; // searches do not nest
            BranchAndBound search(part.state, piece, options, part.control);
            if (values == TakenOver::asInBest) search.offer(part.incumbents.graphs().begin()->second);
            search.run();
            part.workElsewhere += search.work();
            if (search.incumbents().empty()) return false;
            found = search.incumbents().graphs().begin()->second;
        }
        for (const VariableId variable : piece)
            if (!part.state.assign(variable, arcState(found[variable] == 1))) return false;
    }
    return true;
}

} // namespace

bool acceptIntegral(PartSearch& part) {
    for (const VariableId variable : part.variables)
        if (isFractional(part.present(variable))) return false;
    const ColumnState::Mark mark = part.columns.mark();
    const bool valid = std::ranges::all_of(part.variables, [&part](VariableId variable) {
        return part.state.assign(variable, arcState(part.present(variable) > 0.5));
    });
    if (valid) part.recordLeaf();
    part.columns.undo(mark);
    return valid;
}

void roundRelaxed(PartSearch& part) {
    roundAt(part, 0.5);
    if (!part.state.problem().gaps) roundAt(part, integral);
}

void guessGraphs(PartSearch& part) {
    for (const double threshold : {2.0, -1.0})
        if (part.columns.consistent()) roundAt(part, threshold);
}

void dive(PartSearch& part) {
    while (!part.isOver() && fixSurest(part)) {
        if (part.relaxation.solve(part.columns, part.incumbents.cutoff(), Tuning::iterations).kind !=
            Relaxation::Result::Kind::solved)
            return;
        if (acceptIntegral(part)) return;
        roundRelaxed(part);
    }
}

void diveToRest(PartSearch& part) {
    while (!part.isOver()) {
        const ColumnState::Mark mark = part.columns.mark();
        const bool found = takeOverAll(part, TakenOver::integral) <= Tuning::smallRest &&
                           searchRest(part, TakenOver::integral);
        if (found) part.recordLeaf();
        part.columns.undo(mark);
        if (found || !fixSurest(part) ||
            part.relaxation.solve(part.columns, part.incumbents.cutoff(), Tuning::iterationsBeforeSearch)
                    .kind != Relaxation::Result::Kind::solved)
            return;
    }
}

void searchNearby(PartSearch& part) {
    if (part.incumbents.empty()) return;
    const ColumnState::Mark mark = part.columns.mark();
    const std::size_t open = takeOverAll(part, TakenOver::asInBest);
    if (open <= Tuning::largeRest && 2 * open < part.variables.size() &&
        searchRest(part, TakenOver::asInBest))
        part.recordLeaf();
    part.columns.undo(mark);
}

} // namespace qm

#include "enumerate/optimum/rounding.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

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

} // namespace qm

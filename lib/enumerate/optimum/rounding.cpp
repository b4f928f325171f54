#include "enumerate/optimum/rounding.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// Takes everything above the threshold in, the surest values first, and follows every conclusion.
void roundAt(PartSearch& part, double threshold) {
    std::vector<std::pair<double, int>> order;
    for (const int variable : part.variables)
        if (part.state.isFree(variable))
            order.emplace_back(-std::abs(part.present(variable) - threshold), variable);
    std::ranges::sort(order);
    const ParticleState::Mark mark = part.particles.mark();
    bool valid = true;
    for (const auto& [doubt, variable] : order) {
        if (!part.state.isFree(variable)) continue;
        const bool up = part.present(variable) > threshold;
        const SearchState::Mark before = part.state.mark();
        if (part.state.assign(variable, up ? ArcState::in : ArcState::out)) continue;
        part.state.undo(before);
        valid = part.state.assign(variable, up ? ArcState::out : ArcState::in);
        if (!valid) break;
    }
    if (valid) part.recordLeaf();
    part.particles.undo(mark);
}

} // namespace

bool acceptIntegral(PartSearch& part) {
    for (const int variable : part.variables)
        if (isFractional(part.present(variable))) return false;
    const ParticleState::Mark mark = part.particles.mark();
    const bool valid = std::ranges::all_of(part.variables, [&part](int variable) {
        const ArcState value = part.present(variable) > 0.5 ? ArcState::in : ArcState::out;
        return part.state.isFree(variable) ? part.state.assign(variable, value)
                                           : part.state.value(variable) == value;
    });
    if (valid) part.recordLeaf();
    part.particles.undo(mark);
    return valid;
}

void roundRelaxed(PartSearch& part) {
    roundAt(part, 0.5);
    if (!part.state.problem().gaps) roundAt(part, integral);
}

void guessGraphs(PartSearch& part) {
    for (const double threshold : {2.0, -1.0})
        if (part.particles.consistent()) roundAt(part, threshold);
}

} // namespace qm

#include "bspline/fitting/system/continuity_equations.h"

#include "bspline/network/continuity.h"

namespace qm {

std::vector<LinearForm> continuityEquations(const KnotPlan& plan, const std::vector<PatchSpace>& spaces,
                                            const std::vector<bool>& isFree) {
    const auto counts = [&](const Stretch& stretch) {
        return isFree[stretch.sides[0].patch] || isFree[stretch.sides[1].patch];
    };
    const auto strips = [&](const Stretch& stretch) -> StripPair {
        const auto strip = [&](const StretchSide& place) {
            return BorderStrip(spaces[place.patch], plan.sizes()[place.patch], place);
        };
        return {strip(stretch.sides[0]), strip(stretch.sides[1])};
    };
    std::vector<LinearForm> equations;
    for (const Stretch& stretch : plan.stretches())
        if (counts(stretch)) addPositionEquations(stretch, strips(stretch), equations);
    for (const SmoothRun& run : plan.runs())
        if (const Stretch& stretch = plan.stretches()[run.stretch]; counts(stretch))
            addTangentEquations(run, strips(stretch), equations);
    return equations;
}

std::size_t unknownsOf(const std::vector<PatchSpace>& spaces) {
    return spaces.empty() ? 0 : spaces.back().firstUnknown + spaces.back().size();
}

FreeUnknowns::FreeUnknowns(const std::vector<PatchSpace>& spaces, const std::vector<bool>& isFree) {
    for (std::size_t patch = 0; patch < spaces.size(); ++patch)
        for (std::size_t k = 0; k < spaces[patch].size(); ++k)
            numbers_.push_back(isFree[patch] ? count_++ : none);
}

LinearForm FreeUnknowns::among(const LinearForm& form) const {
    LinearForm result;
    result.unknowns.reserve(form.unknowns.size());
    result.weights.reserve(form.unknowns.size());
    for (std::size_t k = 0; k < form.unknowns.size(); ++k) {
        if (!isFree(form.unknowns[k])) continue;
        result.unknowns.push_back(number(form.unknowns[k]));
        result.weights.push_back(form.weights[k]);
    }
    return result;
}

} // namespace qm

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

} // namespace qm

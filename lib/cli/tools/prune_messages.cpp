#include "cli/tools/prune_messages.h"

#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace qm {

namespace {

/// By how much a layout may be above the best, with three decimals, which suffice to judge it.
std::string distanceText(double objective, double bound) {
    constexpr double digits = 1000;
    return "at most " + numberText(std::ceil((objective - bound) * digits) / digits) + " above the best";
}

std::string openQuestion(const PruneOptions& options, const PruneResult& pruned) {
    if (options.fewestPatches && *pruned.objective <= *pruned.objectiveBound)
        return "no layout has fewer segments, but one of as many may cost less";
    return "the layout is " + distanceText(*pruned.objective, *pruned.objectiveBound);
}

} // namespace

void reportProofs(const Tool& tool, const PruneOptions& options, const PruneResult& pruned) {
    if (options.method == PruneMethod::optimum && !pruned.proven)
        tool.warnOfInput("the search was ended early; " + openQuestion(options, pruned));
    for (const FrontPoint& point : pruned.front)
        tool.note("front: beta " + numberText(point.beta) + ", " + std::to_string(point.segments) +
                  " segments, G_T " + numberText(point.cost) + ", " +
                  (point.proven ? "proven"
                                : distanceText(point.cost + point.beta * static_cast<double>(point.segments),
                                               point.objectiveBound)));
    const auto open = std::ranges::count(pruned.front, false, &FrontPoint::proven);
    if (open > 0)
        tool.warnOfInput("the search was ended early; " + std::to_string(open) + " of " +
                         std::to_string(pruned.front.size()) + " layouts of the front are not proven");
}

} // namespace qm

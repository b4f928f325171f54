#include "merge/improve.h"

#include "base/deadline.h"
#include "base/parallel.h"
#include "merge/graph_improver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace qm {
namespace {

struct Tuning {
    /// Share of the time for the search of the whole mesh, which gives both bound and graph. If it is large,
    /// its relaxation may take all of the time: there is no other bound.
    static constexpr double shareOfTree = 0.55;
    /// Share of the time for the windows that a single thread searches before the whole mesh.
    static constexpr double shareOfFirst = 0.2;
    /// Share of the time after which a single thread improves the bound and no longer the graph, which gains
    /// little by then.
    static constexpr double shareOfGraph = 0.65;
};

/// The sum of what the decomposition bound adds to the bounds of the parts.
double boundGain(const std::vector<OpenPart>& parts, const Deadline& end, const Control& control,
                 const std::function<void(double)>& tell) {
    double gain = 0;
    for (const OpenPart& part : parts) {
        DecompositionOptions options;
        options.seconds = end.secondsLeft();
        gain += std::max(0.0, decompositionBound(part.relaxed, options, control) - part.lowerBound);
        tell(gain);
    }
    return gain;
}

} // namespace

Improvement improveGraph(const SearchSpace& space, PresentArcs present, double seconds,
                         const Control& control, const KnownCost& tell) {
    KnownSoFar known(control, tell, costOf(space, present));
    const Control telling = known.control();
    GraphImprover improver(space, std::move(present), known);
    const double shareOfTree = improver.isLarge() ? 1 : Tuning::shareOfTree;
    const bool together = telling.jobs > 1; // whether windows and bounds are computed at the same time
    const Deadline end(telling, seconds), tree(telling, shareOfTree * seconds),
        first(telling, (together ? shareOfTree : Tuning::shareOfFirst) * seconds),
        windows(telling, together ? seconds : Tuning::shareOfGraph * seconds);

    Control ofFirst = first.control();
    ofFirst.jobs = std::max(1U, telling.jobs - 1);
    const OptimumResult found = improver.searchTree(tree.control(), ofFirst);
    double lowerBound = found.lowerBound;
    known.setBound(lowerBound);
    control.progress(Tuning::shareOfTree);
    if (!found.complete) {
        const std::array<std::function<void()>, 2> work{
            [&] {
                // Without open parts there is no bound to improve, and windows get all time and threads.
                const bool alone = found.openParts.empty();
                Control ofWindows = (alone ? end : windows).control();
                if (together && !alone) ofWindows.jobs -= telling.jobs / 2;
                improver.searchWindows(found.relaxed, {.patient = true}, ofWindows);
            },
            [&] {
                Control ofBounds = telling;
                if (together) ofBounds.jobs = telling.jobs / 2;
                lowerBound += boundGain(found.openParts, end, ofBounds,
                                        [&](double gain) { known.setBound(found.lowerBound + gain); });
            }};
        parallelFor(work.size(), together ? 2 : 1, [&](std::size_t k) { work[k](); });
    }
    control.progress(1);
    return {improver.result(), boundBelow(lowerBound, costOf(space, improver.result().present))};
}

double boundBelow(double lowerBound, double cost) {
    // The bound adds the same costs in another order than the tracks' costs do.
    const double rounding = 1e-6 * (1 + std::abs(cost));
    if (lowerBound > cost + rounding)
        throw std::logic_error("a lower bound of " + std::to_string(lowerBound) +
                               " was computed, but there is a graph of cost " + std::to_string(cost));
    return std::min(lowerBound, cost);
}

} // namespace qm

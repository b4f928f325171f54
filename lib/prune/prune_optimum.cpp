#include "prune/prune_optimum.h"

#include "base/deadline.h"
#include "base/error.h"
#include "layout/quality.h"
#include "prune/pruning_search.h"
#include "prune/rounded_edges.h"
#include "prune/turned_sides.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

struct FrontTuning {
    static constexpr double cheapestPrice = 1.0 / 16; ///< of a segment; the next is twice as much
    static constexpr int prices = 11;                 ///< up to 64, where next to nothing but segments counts
};

PruneResult resultOf(const PruningSearch& search, const PruningSearch::Found& found) {
    PruneResult result;
    result.layout = search.layoutOf(found.values);
    result.objective = result.layout.cost;
    result.objectiveBound = found.lowerBound;
    result.proven = found.proven;
    return result;
}

double segmentsOf(const Layout& layout) {
    return static_cast<double>(layout.segments.size());
}

/// As few segments as can be, then the lowest G_T with no more than that.
PruneResult pruneToFewest(PruningSearch& search, double seconds, const Control& control) {
    const Deadline end(control, seconds);
    const PruningSearch::Found fewest = search.findFewest(seconds / 2);
    PruneResult result =
        resultOf(search, search.findCheapest({0, search.segments(fewest.values)}, end.secondsLeft()));
    result.proven = result.proven && fewest.proven;
    result.objective = segmentsOf(result.layout);
    result.objectiveBound = fewest.lowerBound;
    return result;
}

PruneResult pruneToOptimum(PruningSearch& search, const PruneOptions& options, double seconds,
                           const Control& control) {
    if (options.fewestPatches) return pruneToFewest(search, seconds, control);
    PruningAim aim{options.beta};
    if (std::isfinite(options.maxSegments)) aim = {0, options.maxSegments};
    PruneResult result = resultOf(search, search.findCheapest(aim, seconds));
    *result.objective += aim.beta * segmentsOf(result.layout);
    return result;
}

/// Layouts for a range of prices, from many segments to few.
std::vector<FrontPoint> findFront(PruningSearch& search, const PrunedMesh& pruned, double rho, double seconds,
                                  const Control& control) {
    const Deadline end(control, seconds);
    std::vector<FrontPoint> front;
    int left = FrontTuning::prices;
    for (double beta = FrontTuning::cheapestPrice; left > 0 && !control.stopRequested(); beta *= 2, --left) {
        const PruningSearch::Found found =
            search.findCheapest({beta}, std::min(end.secondsLeft(), seconds) / left);
        const Layout layout = search.layoutOf(found.values);
        const LayoutQuality quality = measureLayout(pruned.mesh, layout, pruned.dihedralAngles, rho);
        addToFront(front, {beta, quality.segments, layout.cost, quality.capturedSharpness, found.lowerBound,
                           found.proven});
    }
    std::ranges::sort(front, std::ranges::greater{}, &FrontPoint::segments);
    return front;
}

PruneResult pruneFrom(const Layout& layout, const PrunedMesh& pruned, const PruneOptions& options, double rho,
                      const Control& control) {
    const bool greedy = options.method == PruneMethod::greedy;
    PruneResult result;
    if (greedy) result = pruneLayout(pruned, layout, options, control);
    if (greedy && !options.front) return result;
    const Deadline end(control, options.timeLimit);
    PruningSearch search(pruned, layout, options, control);
    if (!greedy)
        result = pruneToOptimum(search, options, options.timeLimit / (options.front ? 2 : 1), control);
    if (options.front) result.front = findFront(search, pruned, rho, end.secondsLeft(), control);
    return result;
}

} // namespace

PruneResult prune(const PrunedMesh& pruned, const Layout& layout, const PruneOptions& options, double rho,
                  const Control& control) {
    // Somebody may have added constraints after the layout was made.
    if (!obeyConstraints(pruned.mesh, properTracks(layout), options.constraints))
        throw Error("/constraints", "the layout does not obey them", "Run qm-enum and qm-merge again");
    constexpr double halfTurn = 180; // no line turns by more
    if (!options.smooth || options.maxSharpTurn >= halfTurn)
        return pruneFrom(layout, pruned, options, rho, control);
    const auto& forbidden = options.constraints.forbidden;
    const bool isGreedy = options.method == PruneMethod::greedy;
    AddedTracks before(pruned, layout, forbidden);
    cutTurnedSides(pruned, options.maxSharpTurn, before);
    if (isGreedy) cutTurnedOutlines(pruned.mesh, options.maxSharpTurn, before);
    PruneResult result =
        pruneFrom(before.count() > 0 ? before.layout() : layout, pruned, options, rho, control);
    result.addedTracks = before.count();
    if (!isGreedy && (options.fewestPatches || std::isfinite(options.maxSegments))) return result;
    AddedTracks after(pruned, result.layout, forbidden);
    // The optimum knows no tracks off the base complex, so these come after it.
    if (!isGreedy) cutTurnedOutlines(pruned.mesh, options.maxSharpTurn, after);
    cutAlongRoundedEdges(pruned, after);
    if (after.count() > 0) result.layout = after.layout();
    result.addedTracks += after.count();
    return result;
}

} // namespace qm

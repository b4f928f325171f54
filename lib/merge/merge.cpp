#include "merge/merge.h"

#include "base/deadline.h"
#include "base/error.h"
#include "enumerate/paper/plain_graph.h"
#include "enumerate/state/incumbents.h"
#include "layout/tracks.h"
#include "merge/across_cut.h"
#include "merge/generators.h"
#include "merge/improve.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace qm {
namespace {

bool obeys(const SearchSpace& space, const PresentArcs& present) {
    for (const ArcId arc : space.demands.ids())
        if (space.demands[arc] != ArcState::free && present[arc] != (space.demands[arc] == ArcState::in))
            return false;
    return true;
}

/// The graph of a T-mesh enumeration; it covers the whole mesh, so there is nothing to merge.
MergeResult wholeGraph(const Enumeration& enumeration) {
    const SubMeshGraphs& found = enumeration.subMeshes.front();
    if (found.graphs.empty())
        throw Error("/enumeration/subMeshes/0/graphs", "no graph was found", "Give qm-enum more time");
    MergeResult result;
    result.graph = found.graphs.front();
    if (enumeration.cost.terms.segments == 0) result.lowerBound = found.lowerBound;
    return result;
}

/// Replaces a graph by the plain one if that is cheaper, as it may be because each sub-mesh was searched
/// without regard to the others.
/// \return whether it was
bool takePlainIfCheaper(const SearchedMesh& searched, const std::vector<double>& edgeCosts,
                        const SearchSpace& space, PresentArcs& present) {
    const auto& [mesh, complex] = std::tie(searched.mesh, searched.complex);
    PresentArcs plain =
        presentArcs({mesh, complex, space.graph}, plainMotorcycleGraph(mesh, complex, edgeCosts).tracks);
    if (!obeys(space, plain) || costOf(space, plain) >= costOf(space, present)) return false;
    present = std::move(plain);
    return true;
}

/// Searches the whole mesh where that is quick, and moves the cut where that has not ended with a proof.
/// \return a lower bound of the whole mesh, if the search has found one
std::optional<double> searchAcrossCut(const SearchSpace& space, double complexityLimit,
                                      const Control& control, PresentArcs& present, MergeResult& result) {
    const std::optional<WholeSearch> whole = searchWhole(space, present, control);
    if (whole) present = whole->present;
    if (!whole || !whole->proven) {
        Control secondHalf = control; // the generators were the first
        secondHalf.progress = [&](double fraction) { control.progress(0.5 + 0.5 * fraction); };
        WindowResult moved = moveCuts(space, present, complexityLimit,
                                      whole ? whole->relaxed : IdVector<ArcId, double>(), secondHalf);
        present = std::move(moved.present);
        result.windows = moved.windows;
        result.improvements = moved.improvements;
    }
    return whole ? std::optional(whole->lowerBound) : std::nullopt;
}

bool isProven(const MergeResult& result) {
    return result.lowerBound && result.graph.cost <= *result.lowerBound + Incumbents::tolerance;
}

} // namespace

MergeResult mergeGraphs(const SearchedMesh& searched, const Enumeration& enumeration, double complexityLimit,
                        const MergeOptions& options, const Control& control, const KnownCost& tell) {
    if (enumeration.graphClass == GraphClass::tmesh) return wholeGraph(enumeration);
    const Deadline end(control, options.timeLimit);
    Control limited = end.control();
    limited.progress = control.progress;
    const auto& [mesh, complex, dihedralAngles, subMeshes, constraints] = searched;
    const std::vector<double> costs = edgeCosts(mesh, dihedralAngles, enumeration.cost, constraints);
    const double corner = cornerCost(enumeration.cost.terms);
    const SearchSpace space = makeSearchSpace(mesh, complex, {costs, corner}, subMeshes, constraints);
    // What ends early is extended without regard to the constraints.
    auto [present, result] = generateGraph(searched, space, enumeration,
                                           {.complexity = complexityLimit, .rounds = options.maxRounds},
                                           space.demands.empty() ? limited : control);
    if (subMeshes.count > 1) result.plain = takePlainIfCheaper(searched, costs, space, present);
    // Free particles are extended straight on without regard to the constraints.
    if (!obeys(space, present))
        throw Error(
            "/constraints", "no graph that obeys them was found one sub-mesh after the other",
            "Lay the cut around these edges, or search the whole mesh with a greater --chi of qm-cut");
    // If segments have a cost, the bound includes it and is no bound of G_T, which sums over edges only.
    const bool bounds = enumeration.cost.terms.segments == 0;
    if (subMeshes.count > 1) {
        const auto lowerBound = searchAcrossCut(space, complexityLimit, limited, present, result);
        if (bounds) result.lowerBound = lowerBound;
    }
    result.graph = graphOf({mesh, complex, space.graph}, present, costs);
    result.costBefore = result.graph.cost;
    if (result.lowerBound) result.lowerBound = boundBelow(*result.lowerBound, result.graph.cost);
    if (subMeshes.count == 1 && bounds) result.lowerBound = enumeration.subMeshes.front().lowerBound;
    if (options.improve > 0 && !isProven(result)) {
        const SearchSpace whole = makeSearchSpace(mesh, complex, {costs, corner}, {}, constraints);
        const Improvement better =
            improveGraph(whole, presentArcs({mesh, complex, whole.graph}, result.graph.tracks),
                         std::min(options.improve, end.secondsLeft()), control, tell);
        result.graph = graphOf({mesh, complex, whole.graph}, better.present, costs);
        if (bounds)
            result.lowerBound =
                boundBelow(std::max(better.lowerBound, result.lowerBound.value_or(better.lowerBound)),
                           result.graph.cost);
        result.windows += better.windows;
        result.improvements += better.improvements;
    }
    result.endedEarly = (subMeshes.count > 1 || options.improve > 0) && end.isOver() && !isProven(result);
    control.progress(1);
    return result;
}

} // namespace qm

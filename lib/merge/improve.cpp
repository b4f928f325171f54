#include "merge/improve.h"

#include "base/deadline.h"
#include "enumerate/optimum.h"
#include "enumerate/search_space.h"
#include "enumerate/tracks.h"
#include "enumerate/window_search.h"

#include <algorithm>

namespace qm {
namespace {

constexpr double shareOfTree = 0.5; ///< of the time; what is near the relaxed solution is good already

/// \param present  arcs of a valid graph
Assignment assignmentOf(const Problem& problem, const std::vector<bool>& present) {
    Assignment assignment(problem.domains.size(), 0);
    assignment[static_cast<std::size_t>(problem.in())] = 1;
    for (std::size_t v = 0; v < problem.arcs.size(); ++v)
        assignment[v] = present[problem.arcs[v].first.idx()] ? 1 : 0;
    return assignment;
}

} // namespace

Improvement improveGraph(const QuadMesh& mesh, const BaseComplex& complex,
                         const std::vector<double>& edgeCosts, double cornerCost,
                         const Constraints& constraints, const MotorcycleGraph& graph, double seconds,
                         const Control& control) {
    const SubMeshes whole{std::vector<int>(mesh.n_vertices(), 0), 1};
    const SearchSpace space = makeSearchSpace(mesh, complex, edgeCosts, whole, constraints, cornerCost);
    const std::vector<bool> nothing(space.graph.arcs.size(), false);
    const Problem problem = subMeshProblem(space, 0, ownArcs(space, 0), nothing);
    const Deadline half(control, shareOfTree * seconds), end(control, seconds);

    OptimumOptions options;
    options.start = assignmentOf(problem, presentArcs(mesh, complex, space.graph, graph.tracks));
    const OptimumResult found = findOptimum(problem, options, half.control());
    control.progress(shareOfTree);
    WindowResult windows;
    windows.graph = found.graphs.empty() ? *options.start : found.graphs.front();
    if (!found.complete) windows = improveByWindows(problem, windows.graph, {}, end.control());
    control.progress(1);

    std::vector<bool> present = nothing;
    apply(problem, windows.graph, present);
    Improvement result;
    result.graph = graphOf(mesh, complex, space.graph, present, edgeCosts);
    // The bound sums what the search summed, in another order than the tracks' costs.
    result.lowerBound = std::min(found.lowerBound, result.graph.cost);
    result.windows = windows.windows;
    result.improvements = windows.improvements;
    return result;
}

} // namespace qm

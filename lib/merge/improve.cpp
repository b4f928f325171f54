#include "merge/improve.h"

#include "base/deadline.h"
#include "enumerate/optimum.h"
#include "enumerate/tracks.h"

#include <algorithm>

namespace qm {
namespace {

constexpr double shareOfTree = 0.3; ///< of the time; windows are the surer way to something better

ProblemInput wholeInput(const SearchSpace& space) {
    return {
        space.graph, space.arcCosts,  std::vector(space.graph.arcs.size(), ArcState::free), space.demands, {},
        {},          space.cornerCost};
}

/// Takes what it finds over into `present`.
OptimumResult searchWhole(const Problem& problem, std::vector<bool>& present, const Control& control) {
    OptimumOptions options;
    options.start = assignmentOf(problem, present);
    OptimumResult found = findOptimum(problem, options, control);
    if (!found.graphs.empty()) apply(problem, found.graphs.front(), present);
    return found;
}

/// \return of every arc its value in the relaxed solution; nothing if there was none
std::vector<double> relaxedArcs(const SearchSpace& space, const Problem& problem,
                                const OptimumResult& found) {
    if (found.relaxed.empty()) return {};
    std::vector<double> values(space.graph.arcs.size(), 0);
    for (std::size_t v = 0; v < problem.arcs.size(); ++v)
        std::fill_n(values.begin() + problem.arcs[v].first.value(), problem.arcs[v].count, found.relaxed[v]);
    return values;
}

} // namespace

Improvement improveGraph(const QuadMesh& mesh, const BaseComplex& complex,
                         const std::vector<double>& edgeCosts, double cornerCost,
                         const Constraints& constraints, const MotorcycleGraph& graph, double seconds,
                         const Control& control) {
    const SubMeshes whole{std::vector<int>(mesh.n_vertices(), 0), 1};
    const SearchSpace space = makeSearchSpace(mesh, complex, edgeCosts, whole, constraints, cornerCost);
    const ProblemInput input = wholeInput(space);
    const Problem problem = makeProblem(input);
    std::vector<bool> present = presentArcs(mesh, complex, space.graph, graph.tracks);
    const Deadline tree(control, shareOfTree * seconds), end(control, seconds);

    Improvement result;
    OptimumResult found = searchWhole(problem, present, tree.control());
    result.lowerBound = found.lowerBound;
    control.progress(shareOfTree);
    if (!found.complete) {
        WindowOptions options;
        options.relaxed = relaxedArcs(space, problem, found);
        WindowResult windows = improveByWindows(input, present, options, end.control());
        present = std::move(windows.present);
        result.windows = windows.windows;
        result.improvements = windows.improvements;
        if (!end.isOver() && !control.stopRequested()) {
            found = searchWhole(problem, present, end.control());
            result.lowerBound = std::max(result.lowerBound, found.lowerBound);
        }
    }
    control.progress(1);
    result.graph = graphOf(mesh, complex, space.graph, present, edgeCosts);
    // The bound sums what the search summed, in another order than the tracks' costs.
    result.lowerBound = std::min(result.lowerBound, result.graph.cost);
    return result;
}

WindowResult moveCuts(const SearchSpace& space, const std::vector<bool>& present, double complexity,
                      const Control& control) {
    constexpr double variablesPerBit = 4; // log2 of the stops of a line as long as they usually are
    constexpr double mostVariables = 1000;
    WindowOptions options;
    options.leastVariables = options.mostVariables =
        static_cast<std::size_t>(std::clamp(variablesPerBit * complexity, 1.0, mostVariables));
    options.mostWindows = 2000;
    return improveByWindows(wholeInput(space), present, options, control);
}

} // namespace qm

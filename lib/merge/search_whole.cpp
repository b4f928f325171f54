#include "merge/search_whole.h"

#include "enumerate/optimum/optimum.h"

#include <cstddef>

namespace qm {
namespace {

struct Tuning {
    /// Number of variables beyond which the relaxation alone may take longer than all windows.
    static constexpr std::size_t maxVariables = 2500;
    /// Limit of the search tree of each part: most parts need a few dozen nodes, others many thousands.
    static constexpr std::size_t nodes = 100;
};

} // namespace

std::optional<WholeSearch> searchWhole(const SearchSpace& space, const std::vector<bool>& present,
                                       const Control& control) {
    const Problem problem = makeProblem(wholeInput(space));
    if (problem.arcs.size() > Tuning::maxVariables) return std::nullopt;
    OptimumOptions options;
    options.start = assignmentOf(problem, present);
    options.nodes = Tuning::nodes;
    const OptimumResult found = findOptimum(problem, options, control);
    WholeSearch result{present, found.lowerBound, found.complete,
                       arcValues(problem, found.relaxed, space.graph.arcs.size())};
    if (!found.graphs.empty()) apply(problem, found.graphs.front(), result.present);
    return result;
}

} // namespace qm

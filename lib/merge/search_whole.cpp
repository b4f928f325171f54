#include "merge/search_whole.h"

#include "enumerate/optimum/optimum.h"

#include <cstddef>
#include <limits>

namespace qm {
namespace {

struct Tuning {
    /// Number of variables beyond which only the root of the search is relaxed: every node takes long there,
    /// and few searches would end with a proof.
    static constexpr std::size_t rootOnly = 2500;
    /// Number of variables beyond which even the root would take longer than all other stages together.
    static constexpr std::size_t maxVariables = 10000;
    /// Limit of the search tree of each part: most parts need a few dozen nodes, others many thousands.
    static constexpr std::size_t nodes = 100;
    /// Limit of the simplex method's work, twice what all but few models need: about a quarter of a minute.
    /// Where the relaxation is weak, a hundred nodes would take five times as long, for a graph that is no
    /// cheaper.
    static constexpr std::size_t work = 400'000'000;
};

} // namespace

std::optional<WholeSearch> searchWhole(const SearchSpace& space, const PresentArcs& present,
                                       const Control& control) {
    const Problem problem = makeProblem(wholeInput(space));
    if (problem.arcs.size() > Tuning::maxVariables) return std::nullopt;
    OptimumOptions options;
    options.start = assignmentOf(problem, present);
    options.nodes = Tuning::nodes;
    options.work = Tuning::work;
    if (problem.arcs.size() > Tuning::rootOnly) {
        constexpr auto never = std::numeric_limits<std::size_t>::max();
        options.nodes = 1;
        options.large = Tuning::rootOnly; // faster, and better graphs are near approximate solutions
        options.cut = never;              // cuts solve the root many times
        options.hard = never;             // searches within the search take longer than the root
    }
    const OptimumResult found = findOptimum(problem, options, control);
    WholeSearch result{present, found.lowerBound, found.complete,
                       arcValues(problem, found.relaxed, space.graph.arcs.size())};
    if (!found.graphs.empty()) apply(problem, found.graphs.front(), result.present);
    return result;
}

} // namespace qm

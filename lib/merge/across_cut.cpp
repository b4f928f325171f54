#include "merge/across_cut.h"

#include "enumerate/optimum/optimum.h"
#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// Limits of the search of the whole mesh. What is hard is a part that is tied together, not the mesh: solids
/// with sharp edges all over fall into thousands of small parts.
struct WholeTuning {
    /// Number of variables beyond which only the root of the search of a part is relaxed: every node takes
    /// long there, and few searches would end with a proof.
    static constexpr std::size_t rootOnly = 2500;
    /// Number of variables, in all such parts together, beyond which even the roots would take longer than
    /// all other stages together.
    static constexpr std::size_t maxVariables = 10000;
    /// Limit of the search tree of each part: most parts need a few dozen nodes, others many thousands.
    static constexpr std::size_t nodes = 100;
    /// Limit of the simplex method's work, twice what all but few models need: about a quarter of a minute.
    /// Where the relaxation is weak, a hundred nodes would take five times as long, for a graph that is no
    /// cheaper.
    static constexpr std::size_t work = 400'000'000;
};

/// Limits of windows along the cut.
struct WindowTuning {
    /// Variables of a window per unit of a sub-mesh's quasi-complexity, so that both are equally hard: about
    /// log2 of the candidate stops on a line of usual length.
    static constexpr double variablesPerBit = 6;
    /// Each window takes a fraction of a second, and all take a few seconds.
    static constexpr double maxVariables = 1000;
    static constexpr std::size_t maxWindows = 2000;
    /// Nearly all models need a fiftieth of this work, which takes a few seconds. Where the relaxation is
    /// weak, trees of 50 nodes alone would take as many minutes.
    static constexpr std::size_t maxWork = 200'000'000;
};

/// How many variables there are in independent parts of more than so many.
std::size_t variablesOfParts(const Problem& problem, std::size_t minSize) {
    std::size_t sum = 0;
    for (const auto& part : independentParts(SearchState(problem)))
        if (part.size() > minSize) sum += part.size();
    return sum;
}

} // namespace

std::optional<WholeSearch> searchWhole(const SearchSpace& space, const PresentArcs& present,
                                       const Control& control) {
    const Problem problem = makeProblem(wholeInput(space));
    const std::size_t inLargeParts = variablesOfParts(problem, WholeTuning::rootOnly);
    if (inLargeParts > WholeTuning::maxVariables) return std::nullopt;
    OptimumOptions options;
    options.start = assignmentOf(problem, present);
    options.nodes = WholeTuning::nodes;
    options.work = WholeTuning::work;
    if (inLargeParts > 0) {
        options.nodes = 1;
        options.large = WholeTuning::rootOnly; // faster, and better graphs are near approximate solutions
        options.cut = PartOptions::never;      // cuts solve the root many times
        options.hard = PartOptions::never;     // searches within the search take longer than the root
    }
    const OptimumResult found = findOptimum(problem, options, control);
    WholeSearch result{present, found.lowerBound, found.complete,
                       arcValues(problem, found.relaxed, space.graph.arcs.size())};
    if (!found.graphs.empty()) apply(problem, found.graphs.front(), result.present);
    return result;
}

WindowResult moveCuts(const SearchSpace& space, const PresentArcs& present, double complexity,
                      IdVector<ArcId, double> relaxed, const Control& control) {
    WindowOptions options;
    options.relaxed = std::move(relaxed);
    options.minVariables = options.maxVariables = static_cast<std::size_t>(
        std::clamp(WindowTuning::variablesPerBit * complexity, 1.0, WindowTuning::maxVariables));
    options.maxWindows = WindowTuning::maxWindows;
    options.work = WindowTuning::maxWork / 10;
    options.maxWork = WindowTuning::maxWork;
    return improveByWindows(wholeInput(space), present, options, control);
}

} // namespace qm

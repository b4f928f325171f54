#include "merge/graph_improver.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace qm {
namespace {

struct Tuning {
    /// Size of the largest windows that the search of the whole mesh waits for: at least `fastWindow`
    /// variables, or one in `fastShare` of all, of a large problem of those in the graph. Such windows take
    /// little of the time of the search itself.
    static constexpr std::size_t fastWindow = 500;
    static constexpr std::size_t fastShare = 8;
    /// Size of the largest windows of a large problem: one in this many of the variables in the graph. For
    /// larger ones the simplex method would take as long as for the whole.
    static constexpr std::size_t largeShare = 2;
    /// Accuracy of the gradients. Nothing follows that would make the bound better, and more digits take
    /// longer than they are worth to it.
    static constexpr double nearlySolved = 5e-3;
};

} // namespace

GraphImprover::GraphImprover(const SearchSpace& space, PresentArcs present, KnownSoFar& known,
                             std::size_t large)
    : space_(space), input_(wholeInput(space)), problem_(makeProblem(input_)), result_{std::move(present)},
      known_(known), large_(large) {}

bool GraphImprover::isLarge() const {
    return problem_.arcs.size() >= large_;
}

OptimumResult GraphImprover::searchTree(const Control& control, const Control& ofFirstWindows) {
    OptimumOptions options;
    options.start = assignmentOf(problem_, result_.present);
    options.large = large_;
    options.nearlySolved = Tuning::nearlySolved;
    options.keepOpenParts = true;
    std::atomic<bool> areOver = false;
    Control beside = ofFirstWindows;
    beside.stopRequested = [&] { return areOver || ofFirstWindows.stopRequested(); };
    Ahead windows(control.jobs, [&] { searchWindows({}, fastWindows(), beside); });
    const struct EndOfSearch { // if it fails, windows need not go on
        std::atomic<bool>& areOver;
        ~EndOfSearch() { areOver = true; }
    } end{areOver};
    bool isRelaxedOnly = false;
    options.near = [&](double bound) {
        known_.setBound(bound);
        isRelaxedOnly = true; // windows find better graphs in the time of the simplex method
        return false;
    };
    options.polish = [&](const Assignment& graph, const IdVector<VariableId, double>& relaxed) {
        windows.wait();
        take(graph);
        searchWindows(relaxed, fastWindows(), control);
        return assignmentOf(problem_, result_.present);
    };
    OptimumResult found = findOptimum(problem_, options, control);
    areOver = isLarge();
    windows.wait();
    if (!found.graphs.empty()) take(found.graphs.front());
    if (isRelaxedOnly) found.openParts.clear(); // clusters of large parts gain next to nothing
    return found;
}

void GraphImprover::searchWindows(const IdVector<VariableId, double>& relaxed, WindowOptions options,
                                  const Control& control) {
    options.relaxed = arcValues(problem_, relaxed, space_.graph.arcs.size());
    options.alongTracks = isLarge();
    if (isLarge())
        options.maxVariables = std::min(options.maxVariables, presentVariables() / Tuning::largeShare);
    options.improved = [&](const PresentArcs& present) { known_.setCost(costOf(space_, present)); };
    WindowResult windows = improveByWindows(input_, result_.present, options, control);
    result_ = {std::move(windows.present), result_.windows + windows.windows,
               result_.improvements + windows.improvements};
}

/// Adopts a graph if it is cheaper.
void GraphImprover::take(const Assignment& graph) {
    if (costOf(problem_, graph) >= costOf(problem_, assignmentOf(problem_, result_.present))) return;
    apply(problem_, graph, result_.present);
    known_.setCost(costOf(space_, result_.present));
}

/// The number of variables that are in the graph: the size of all its tracks.
std::size_t GraphImprover::presentVariables() const {
    const Assignment graph = assignmentOf(problem_, result_.present);
    return static_cast<std::size_t>(std::ranges::count(graph, 1));
}

/// Options for windows that are small enough for the tree search to wait for them.
WindowOptions GraphImprover::fastWindows() const {
    WindowOptions options;
    const std::size_t all = isLarge() ? presentVariables() : problem_.arcs.size();
    options.maxVariables = std::max(Tuning::fastWindow, all / Tuning::fastShare);
    return options;
}

} // namespace qm

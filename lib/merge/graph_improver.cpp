#include "merge/graph_improver.h"

#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

namespace qm {
namespace {

struct Tuning {
    /// Size of the largest windows that the search of the whole mesh waits for: at least `fastWindow`
    /// variables, one in `fastShare` of all, or one in `relaxedShare` after the relaxation of large parts.
    /// Such windows take little of the time of the search itself.
    static constexpr std::size_t fastWindow = 500;
    static constexpr std::size_t fastShare = 8;
    static constexpr std::size_t relaxedShare = 2;
};

} // namespace

GraphImprover::GraphImprover(const SearchSpace& space, std::vector<bool> present, KnownSoFar& known,
                             std::size_t large)
    : space_(space), input_(wholeInput(space)), problem_(makeProblem(input_)), present_(std::move(present)),
      known_(known), large_(large) {}

bool GraphImprover::isLarge() const {
    return problem_.arcs.size() >= large_;
}

OptimumResult GraphImprover::searchTree(const Control& control, const Control& ofFirstWindows) {
    OptimumOptions options;
    options.start = assignmentOf(problem_, present_);
    options.large = large_;
    options.keepOpenParts = true;
    std::atomic<bool> areOver = false;
    Control beside = ofFirstWindows;
    beside.stopRequested = [&] { return areOver || ofFirstWindows.stopRequested(); };
    std::optional<Ahead> windows(std::in_place, control.jobs,
                                 [&] { searchWindows({}, fastWindows(Tuning::fastShare), beside); });
    const struct EndOfSearch { // if it fails, windows need not go on
        std::atomic<bool>& areOver;
        ~EndOfSearch() { areOver = true; }
    } end{areOver};
    options.near = [&](double bound, const IdVector<VariableId, double>& relaxed) {
        known_.setBound(bound);
        if (control.jobs == 1) return; // the relaxation would wait for them
        areOver = true;
        windows->wait();
        areOver = false;
        windows.emplace(control.jobs, [&, relaxed] { searchWindows(relaxed, patientWindows(), beside); });
    };
    options.polish = [&](const Assignment& graph, const IdVector<VariableId, double>& relaxed) {
        areOver = isLarge();
        windows->wait();
        take(graph);
        searchWindows(relaxed, fastWindows(isLarge() ? Tuning::relaxedShare : Tuning::fastShare), control);
        return assignmentOf(problem_, present_);
    };
    OptimumResult found = findOptimum(problem_, options, control);
    areOver = isLarge();
    windows->wait();
    if (!found.graphs.empty()) take(found.graphs.front());
    return found;
}

void GraphImprover::searchWindows(const IdVector<VariableId, double>& relaxed, WindowOptions options,
                                  const Control& control) {
    options.relaxed = arcValues(problem_, relaxed, space_.graph.arcs.size());
    options.improved = [&](const std::vector<bool>& present) { known_.setCost(costOf(space_, present)); };
    WindowResult windows = improveByWindows(input_, present_, options, control);
    present_ = std::move(windows.present);
    windows_ += windows.windows;
    improvements_ += windows.improvements;
}

/// Adopts a graph if it is cheaper.
void GraphImprover::take(const Assignment& graph) {
    if (costOf(problem_, graph) >= costOf(problem_, assignmentOf(problem_, present_))) return;
    apply(problem_, graph, present_);
    known_.setCost(costOf(space_, present_));
}

/// Options for windows that are small enough for the tree search to wait for them.
WindowOptions GraphImprover::fastWindows(std::size_t share) const {
    WindowOptions options;
    options.alongTracks = true;
    options.maxVariables = std::max(Tuning::fastWindow, problem_.arcs.size() / share);
    return options;
}

WindowOptions patientWindows() {
    WindowOptions options;
    options.alongTracks = true;
    options.patient = true;
    return options;
}

} // namespace qm

#include "merge/improve.h"

#include "base/deadline.h"
#include "enumerate/optimum/optimum.h"
#include "layout/tracks.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace qm {
namespace {

struct Tuning {
    /// Of the time, for the search of the whole: it gives bound and graph, so it gets the most.
    static constexpr double shareOfTree = 0.55;
    /// Of the time; from here on the bound is improved, not the graph, which gains little by then.
    static constexpr double shareOfGraph = 0.65;
    /// Variables of the largest windows that the search of the whole waits for: at least `fastWindow`, and
    /// one in `fastShare` of all. Such windows take a small part of what the search itself takes.
    static constexpr std::size_t fastWindow = 500;
    static constexpr std::size_t fastShare = 8;
    /// Variables of a window as hard as a sub-mesh, by the sub-mesh's quasi-complexity: log2 of the stops of
    /// a line that is as long as they usually are.
    static constexpr double variablesPerBit = 6;
    /// Windows that move cuts take a fraction of a second, and all of them a few seconds.
    static constexpr double maxCutWindow = 1000;
    static constexpr std::size_t maxCutWindows = 2000;
};

ProblemInput wholeInput(const SearchSpace& space) {
    return {space.graph, space.arcCosts, {}, space.demands, {}, {}, space.cornerCost};
}

/// What is known of a graph that becomes cheaper, for those who wait.
class Known {
public:
    Known(const Control& control, const KnownCost& tell, double cost)
        : control_(control), tell_(tell), cost_(cost) {}

    void cost(double cost) { cost_ = cost; }
    void bound(double bound) { bound_ = bound; }
    /// Tells what is known whenever it is asked whether to stop.
    [[nodiscard]] Control control() const {
        Control control = control_;
        control.stopRequested = [this] {
            if (tell_) tell_(cost_, bound_);
            return control_.stopRequested();
        };
        return control;
    }

private:
    const Control& control_;
    const KnownCost& tell_;
    std::atomic<double> cost_;
    std::atomic<double> bound_ = -std::numeric_limits<double>::infinity();
};

/// One graph that becomes cheaper, by a search of the whole and by windows.
class Improver {
public:
    /// \param counters  what to count windows and improvements in
    Improver(const SearchSpace& space, std::vector<bool> present, Improvement& counters, Known& known)
        : space_(space), input_(wholeInput(space)), problem_(makeProblem(input_)),
          present_(std::move(present)), counters_(counters), known_(known) {}

    /// \return with the bound
    OptimumResult searchTree(const Control& control) {
        OptimumOptions options;
        options.start = assignmentOf(problem_, present_);
        options.keepOpenParts = true;
        options.polish = [&](const Assignment& graph, const IdVector<VariableId, double>& relaxed) {
            apply(problem_, graph, present_);
            known_.cost(costOf(space_, present_));
            searchWindows(relaxed, fastWindows(), control);
            return assignmentOf(problem_, present_);
        };
        OptimumResult found = findOptimum(problem_, options, control);
        if (!found.graphs.empty()) apply(problem_, found.graphs.front(), present_);
        return found;
    }

    /// \param relaxed  of every variable, or empty
    void searchWindows(const IdVector<VariableId, double>& relaxed, WindowOptions options,
                       const Control& control) {
        options.relaxed = relaxedArcs(relaxed);
        options.improved = [&](const std::vector<bool>& present) { known_.cost(costOf(space_, present)); };
        WindowResult windows = improveByWindows(input_, present_, options, control);
        present_ = std::move(windows.present);
        counters_.windows += windows.windows;
        counters_.improvements += windows.improvements;
    }

    [[nodiscard]] const std::vector<bool>& present() const { return present_; }

private:
    /// Windows that are small enough for the tree to wait for them.
    [[nodiscard]] WindowOptions fastWindows() const {
        WindowOptions options;
        options.maxVariables = std::max(Tuning::fastWindow, problem_.arcs.size() / Tuning::fastShare);
        return options;
    }

    /// The same of every arc.
    [[nodiscard]] std::vector<double> relaxedArcs(const IdVector<VariableId, double>& relaxed) const {
        if (relaxed.empty()) return {};
        std::vector<double> values(space_.graph.arcs.size(), 0);
        for (const VariableId v : problem_.variables())
            std::fill_n(values.begin() + problem_.arcs[v].first.value(), problem_.arcs[v].count, relaxed[v]);
        return values;
    }

    const SearchSpace& space_;
    const ProblemInput input_;
    const Problem problem_;
    std::vector<bool> present_;
    Improvement& counters_;
    Known& known_;
};

} // namespace

Improvement improveGraph(const QuadMesh& mesh, const BaseComplex& complex,
                         const std::vector<double>& edgeCosts, double cornerCost,
                         const Constraints& constraints, const MotorcycleGraph& graph, double seconds,
                         const Control& control, const KnownCost& tell) {
    const SubMeshes whole{std::vector<int>(mesh.n_vertices(), 0), 1};
    const SearchSpace space = makeSearchSpace(mesh, complex, edgeCosts, whole, constraints, cornerCost);
    Known known(control, tell, graph.cost);
    const Control telling = known.control();
    const Deadline tree(telling, Tuning::shareOfTree * seconds),
        windows(telling, Tuning::shareOfGraph * seconds), end(telling, seconds);
    Improvement result;
    Improver improver(space, presentArcs(mesh, complex, space.graph, graph.tracks), result, known);

    const OptimumResult found = improver.searchTree(tree.control());
    result.lowerBound = found.lowerBound;
    known.bound(result.lowerBound);
    control.progress(Tuning::shareOfTree);
    if (!found.complete) {
        WindowOptions allSizes;
        allSizes.patient = true;
        const Deadline& last = found.openParts.empty() ? end : windows; // nothing else may be left to do
        improver.searchWindows(found.relaxed, allSizes, last.control());
    }
    result.graph = graphOf(mesh, complex, space.graph, improver.present(), edgeCosts);
    for (const OpenPart& part : found.openParts) {
        DecompositionOptions options;
        options.seconds = end.secondsLeft();
        const double bound = decompositionBound(part.relaxed, options, telling);
        result.lowerBound += std::max(0.0, bound - part.lowerBound);
        known.bound(result.lowerBound);
    }
    control.progress(1);
    // The bound sums what the search summed, in another order than the tracks' costs.
    result.lowerBound = std::min(result.lowerBound, result.graph.cost);
    return result;
}

WindowResult moveCuts(const SearchSpace& space, const std::vector<bool>& present, double complexity,
                      const Control& control) {
    WindowOptions options;
    options.minVariables = options.maxVariables =
        static_cast<std::size_t>(std::clamp(Tuning::variablesPerBit * complexity, 1.0, Tuning::maxCutWindow));
    options.maxWindows = Tuning::maxCutWindows;
    return improveByWindows(wholeInput(space), present, options, control);
}

} // namespace qm

#include "merge/improve.h"

#include "base/deadline.h"
#include "base/parallel.h"
#include "enumerate/optimum/optimum.h"
#include "layout/tracks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace qm {
namespace {

struct Tuning {
    /// Share of the time for the search of the whole mesh, which gives both bound and graph. If parts are
    /// large, their root may take all of the time, because there is no bound before.
    static constexpr double shareOfTree = 0.55;
    /// Share of the time for the windows that a single thread searches before the whole mesh.
    static constexpr double shareOfFirst = 0.2;
    /// Share of the time after which a single thread improves the bound and no longer the graph, which gains
    /// little by then.
    static constexpr double shareOfGraph = 0.65;
    /// From this number of variables on, only the root of a part is searched: the simplex method alone would
    /// take half a minute.
    static constexpr std::size_t large = 15000;
    /// Size of the largest windows that the search of the whole mesh waits for: at least `fastWindow`
    /// variables, one in `fastShare` of all, or one in `relaxedShare` after the relaxation of large parts.
    /// Such windows take little of the time of the search itself.
    static constexpr std::size_t fastWindow = 500;
    static constexpr std::size_t fastShare = 8;
    static constexpr std::size_t relaxedShare = 2;
    /// Variables of a window per unit of a sub-mesh's quasi-complexity, so that both are equally hard: about
    /// log2 of the candidate stops on a line of usual length.
    static constexpr double variablesPerBit = 6;
    /// Limits for the windows that move cuts: each takes a fraction of a second, and all take a few seconds.
    static constexpr double maxCutWindow = 1000;
    static constexpr std::size_t maxCutWindows = 2000;
};

ProblemInput wholeInput(const SearchSpace& space) {
    return {space.graph, space.arcCosts, {}, space.demands, {}, {}, space.cornerCost};
}

/// The known cost and bound of a graph while it is being improved, for callers who want to follow.
class Known {
public:
    Known(const Control& control, const KnownCost& tell, double cost)
        : control_(control), tell_(tell), cost_(cost) {}

    void cost(double cost) { cost_ = cost; }
    void bound(double bound) { bound_ = bound; }
    /// A control that reports the known cost and bound whenever it is asked whether to stop.
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

/// Makes one graph cheaper, by a search of the whole mesh and by windows.
class Improver {
public:
    /// \param counters  its numbers of windows and improvements are updated
    Improver(const SearchSpace& space, std::vector<bool> present, Improvement& counters, Known& known)
        : space_(space), input_(wholeInput(space)), problem_(makeProblem(input_)),
          present_(std::move(present)), counters_(counters), known_(known) {}

    [[nodiscard]] bool isLarge() const { return problem_.arcs.size() >= Tuning::large; }

    /// Searches the whole mesh, and at the same time windows of the present graph.
    /// \param first  control of the windows that are searched before the relaxation is known
    /// \return includes the lower bound
    OptimumResult searchTree(const Control& control, const Control& first) {
        OptimumOptions options;
        options.start = assignmentOf(problem_, present_);
        options.large = Tuning::large;
        options.keepOpenParts = true;
        Ahead windows(control.jobs, [&] { searchWindows({}, fastWindows(Tuning::fastShare), first); });
        options.polish = [&](const Assignment& graph, const IdVector<VariableId, double>& relaxed) {
            windows.wait();
            take(graph);
            searchWindows(relaxed, fastWindows(isLarge() ? Tuning::relaxedShare : Tuning::fastShare),
                          control);
            return assignmentOf(problem_, present_);
        };
        OptimumResult found = findOptimum(problem_, options, control);
        windows.wait();
        if (!found.graphs.empty()) take(found.graphs.front());
        return found;
    }

    /// \param relaxed  relaxed value of every variable; may be empty
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
    /// Adopts a graph if it is cheaper.
    void take(const Assignment& graph) {
        if (costOf(problem_, graph) >= costOf(problem_, assignmentOf(problem_, present_))) return;
        apply(problem_, graph, present_);
        known_.cost(costOf(space_, present_));
    }

    /// Options for windows that are small enough for the tree search to wait for them.
    [[nodiscard]] WindowOptions fastWindows(std::size_t share) const {
        WindowOptions options;
        options.maxVariables = std::max(Tuning::fastWindow, problem_.arcs.size() / share);
        return options;
    }

    /// The relaxed value of every arc.
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

/// The sum of what the decomposition bound adds to the bounds of the parts.
double boundGain(const std::vector<OpenPart>& parts, const Deadline& end, const Control& control,
                 const std::function<void(double)>& tell) {
    double gain = 0;
    for (const OpenPart& part : parts) {
        DecompositionOptions options;
        options.seconds = end.secondsLeft();
        gain += std::max(0.0, decompositionBound(part.relaxed, options, control) - part.lowerBound);
        tell(gain);
    }
    return gain;
}

} // namespace

Improvement improveGraph(const QuadMesh& mesh, const BaseComplex& complex,
                         const std::vector<double>& edgeCosts, double cornerCost,
                         const Constraints& constraints, const MotorcycleGraph& graph, double seconds,
                         const Control& control, const KnownCost& tell) {
    const SearchSpace space = makeSearchSpace(mesh, complex, edgeCosts, {}, constraints, cornerCost);
    Known known(control, tell, graph.cost);
    const Control telling = known.control();
    Improvement result;
    Improver improver(space, presentArcs(mesh, complex, space.graph, graph.tracks), result, known);
    const double shareOfTree = improver.isLarge() ? 1 : Tuning::shareOfTree;
    const bool together = telling.jobs > 1; // whether windows and bounds are computed at the same time
    const Deadline end(telling, seconds), tree(telling, shareOfTree * seconds),
        first(telling, (together ? shareOfTree : Tuning::shareOfFirst) * seconds),
        windows(telling, together ? seconds : Tuning::shareOfGraph * seconds);

    Control ofFirst = first.control();
    ofFirst.jobs = std::max(1U, telling.jobs - 1);
    const OptimumResult found = improver.searchTree(tree.control(), ofFirst);
    result.lowerBound = found.lowerBound;
    known.bound(result.lowerBound);
    control.progress(Tuning::shareOfTree);
    if (!found.complete) {
        const std::array<std::function<void()>, 2> work{
            [&] {
                WindowOptions allSizes;
                allSizes.patient = true;
                // Without open parts there is no bound to improve, and windows get all of the time.
                Control ofWindows = (found.openParts.empty() ? end : windows).control();
                if (together) ofWindows.jobs -= telling.jobs / 2;
                improver.searchWindows(found.relaxed, allSizes, ofWindows);
            },
            [&] {
                Control ofBounds = telling;
                if (together) ofBounds.jobs = telling.jobs / 2;
                result.lowerBound += boundGain(found.openParts, end, ofBounds,
                                               [&](double gain) { known.bound(found.lowerBound + gain); });
            }};
        parallelFor(work.size(), together ? 2 : 1, [&](std::size_t k) { work[k](); });
    }
    result.graph = graphOf(mesh, complex, space.graph, improver.present(), edgeCosts);
    control.progress(1);
    result.lowerBound = boundBelow(result.lowerBound, result.graph.cost);
    return result;
}

double boundBelow(double lowerBound, double cost) {
    // The bound adds the same costs in another order than the tracks' costs do.
    const double rounding = 1e-6 * (1 + std::abs(cost));
    if (lowerBound > cost + rounding)
        throw std::logic_error("a lower bound of " + std::to_string(lowerBound) +
                               " was computed, but there is a graph of cost " + std::to_string(cost));
    return std::min(lowerBound, cost);
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

#include "enumerate/optimum/optimum.h"

#include "enumerate/diagram/ranked_graphs.h"
#include "enumerate/optimum/branch_and_bound.h"
#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The cost of the variables that are in already, and of the corners between them.
double fixedCost(const SearchState& state) {
    return costOf(state.problem(), state.assignment());
}

/// Extends a graph of one part to a graph of the whole problem, and polishes it.
Assignment polishPart(const std::vector<VariableId>& part, const Assignment& best,
                      const std::vector<double>& relaxedPart, const OptimumOptions& options,
                      IdVector<VariableId, double> relaxed) {
    Assignment graph = *options.start;
    for (std::size_t k = 0; k < part.size(); ++k) {
        graph[part[k]] = best[part[k]];
        relaxed[part[k]] = relaxedPart[k];
    }
    return options.polish(graph, relaxed);
}

/// The cheapest graph of the whole problem, from a decision diagram that is built at most once; none if the
/// diagram would be too large.
class DiagramOptimum {
public:
    DiagramOptimum(const Problem& problem, const Control& control) : problem_(problem), control_(control) {}

    const std::optional<Assignment>& operator()() {
        if (std::exchange(tried_, true)) return best_;
        const auto diagram = buildDiagram(problem_, smallDiagram, control_);
        if (diagram)
            forEachRankedGraph(*diagram, [&](double /*cost*/, const Assignment& graph) {
                best_ = graph;
                return false;
            });
        return best_;
    }

private:
    const Problem& problem_;
    const Control& control_;
    bool tried_ = false;
    std::optional<Assignment> best_;
};

/// Finds one graph: the best graphs of all parts together.
void searchParts(SearchState& state, const OptimumOptions& options, const Control& control,
                 OptimumResult& result) {
    Assignment graph = state.assignment();
    if (options.start) result.relaxed.assign(options.start->begin(), options.start->end());
    auto parts = independentParts(state);
    // The largest part comes last, so that all others are proven if time runs out.
    std::ranges::stable_sort(parts, {}, [](const auto& part) { return part.size(); });
    DiagramOptimum diagramOptimum(state.problem(), control);
    double done = 0;
    bool found = true;
    for (const auto& part : parts) {
        const bool small = part.size() < options.hard && options.nodes > options.nodesBeforeDiagram;
        PartOptions partOptions{1,
                                infinity,
                                options.gap / static_cast<double>(parts.size()),
                                small ? options.nodesBeforeDiagram : options.nodes,
                                options.hard,
                                options.cut};
        if (options.start) partOptions.large = options.large;
        if (part.size() >= partOptions.large) partOptions.nodes = 1;
        if (options.start && options.polish)
            partOptions.polish = [&](const Assignment& best, const std::vector<double>& relaxed) {
                return polishPart(part, best, relaxed, options, result.relaxed);
            };
        BranchAndBound search(state, part, partOptions, control);
        if (options.start) search.offer(*options.start);
        search.run();
        if (small && !search.complete() && !control.stopRequested()) {
            if (const auto& best = diagramOptimum())
                search.conclude(*best);
            else
                search.resume(options.nodes);
        }
        if (options.keepOpenParts && !search.complete())
            if (auto root = search.relaxedRoot())
                result.openParts.push_back({std::move(*root), search.lowerBound()});
        result.nodes += search.nodes();
        result.lowerBound += search.lowerBound();
        for (std::size_t k = 0; k < search.rootPresence().size() && options.start; ++k)
            result.relaxed[part[k]] = search.rootPresence()[k];
        result.complete = result.complete && search.complete();
        found = found && !search.incumbents().empty();
        if (!search.incumbents().empty())
            for (const VariableId v : part)
                graph[v] = search.incumbents().graphs().begin()->second[v];
        control.progress(++done / static_cast<double>(parts.size()));
    }
    if (found && costOf(state.problem(), graph) <= options.maxCost + Incumbents::tolerance)
        result.graphs.push_back(std::move(graph));
}

/// Finds several graphs. Choices of different parts combine, so all parts are searched together.
void searchTogether(SearchState& state, const OptimumOptions& options, const Control& control,
                    OptimumResult& result) {
    std::vector<VariableId> variables;
    for (const VariableId v : state.problem().variables())
        if (state.isFree(v)) variables.push_back(v);
    BranchAndBound search(
        state, variables,
        {options.best, options.maxCost - result.lowerBound, 0, options.nodes, options.hard, options.cut},
        control);
    if (options.start) search.offer(*options.start);
    search.run();
    result.nodes = search.nodes();
    result.lowerBound += search.lowerBound();
    result.complete = search.complete();
    for (const auto& [cost, graph] : search.incumbents().graphs())
        result.graphs.push_back(graph);
}

/// \return false if `visit` returned false
template <class Visit> bool rank(const Diagram& diagram, const OptimumOptions& options, const Visit& visit) {
    std::size_t left = options.best;
    bool ended = false;
    forEachRankedGraph(diagram, [&](double cost, const Assignment& graph) {
        if (left-- == 0 || cost > options.maxCost + Incumbents::tolerance) return false;
        ended = !visit(graph);
        return !ended;
    });
    return !ended;
}

} // namespace

OptimumResult findOptimum(const Problem& problem, const OptimumOptions& options, const Control& control) {
    SearchState state(problem);
    if (!state.consistent()) return {{}, infinity, true, 0, {}, {}};
    OptimumResult result;
    result.lowerBound = fixedCost(state);
    if (state.freeVariables() == 0 || options.best == 1)
        searchParts(state, options, control, result);
    else
        searchTogether(state, options, control, result);
    return result;
}

OptimumResult findBest(const Problem& problem, const OptimumOptions& options, const Control& control) {
    if (options.best == 1) return findOptimum(problem, options, control);
    const auto diagram = buildDiagram(problem, smallDiagram, control);
    if (!diagram) return findOptimum(problem, options, control);
    OptimumResult result;
    result.lowerBound = diagram->fixedCost + cheapestWays(*diagram)[diagram->root];
    rank(*diagram, options, [&](const Assignment& graph) {
        result.graphs.push_back(graph);
        return true;
    });
    return result;
}

bool forEachBest(const Problem& problem, const OptimumOptions& options,
                 const std::function<bool(const Assignment&)>& visit, const Control& control) {
    if (const auto diagram = buildDiagram(problem, smallDiagram, control))
        return rank(*diagram, options, visit);
    const OptimumResult found = findOptimum(problem, options, control);
    return std::ranges::all_of(found.graphs, visit) && found.complete;
}

} // namespace qm

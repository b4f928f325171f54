#include "enumerate/optimum/optimum.h"

#include "base/infinity.h"
#include "enumerate/diagram/cheapest_graph.h"
#include "enumerate/diagram/ranked_graphs.h"
#include "enumerate/optimum/branch_and_bound.h"
#include "enumerate/state/independent_parts.h"

#include <algorithm>
#include <utility>

namespace qm {
namespace {

/// Finds one graph: the best graphs of all parts together.
class PartsSearch {
public:
    PartsSearch(SearchState& state, const OptimumOptions& options, const Control& control,
                OptimumResult& result)
        : state_(state), options_(options), control_(control), result_(result), graph_(state.assignment()),
          parts_(independentParts(state)) {
        // The largest part comes last, so that all others are proven if time runs out.
        std::ranges::stable_sort(parts_, {}, [](const auto& part) { return part.size(); });
        if (options.start) result.relaxed.assign(options.start->begin(), options.start->end());
    }

    void run() {
        bool found = true;
        for (const Part& part : parts_)
            variablesLeft_ += part.size();
        for (const Part& part : parts_) {
            found = searchPart(part) && found;
            variablesLeft_ -= part.size();
        }
        if (found && costOf(state_.problem(), graph_) <= options_.maxCost + Incumbents::tolerance)
            result_.graphs.push_back(std::move(graph_));
    }

private:
    using Part = std::vector<VariableId>;

    /// \return whether there is a graph of the part
    bool searchPart(const Part& part) {
        BranchAndBound search(state_, part, optionsOf(part), control_);
        if (options_.start) search.offer(*options_.start);
        if (options_.start && options_.polish)
            search.polishWith([&](const Assignment& best, const std::vector<double>& relaxed) {
                return polish(part, best, relaxed);
            });
        if (options_.start && options_.near)
            search.tellNear([&](double bound) {
                // Of later parts nothing is known yet, but usually only the last is large.
                return options_.near(&part == &parts_.back() ? result_.lowerBound + bound : -infinity);
            });
        search.run();
        if (mayUseDiagram(part) && !search.complete() && !control_.stopRequested()) {
            if (const auto& best = diagramOptimum())
                search.conclude(*best);
            else
                search.resume(options_.nodes);
        }
        add(part, search);
        if (search.incumbents().empty()) return false;
        for (const VariableId v : part)
            graph_[v] = search.incumbents().graphs().begin()->second[v];
        return true;
    }

    /// The cheapest graph of the whole problem, from a decision diagram that is built at most once; none if
    /// the diagram would be too large.
    const std::optional<Assignment>& diagramOptimum() {
        if (std::exchange(diagramIsTried_, true)) return diagramOptimum_;
        if (const auto diagram = buildDiagram(state_.problem(), smallDiagram, control_))
            diagramOptimum_ = cheapestGraph(*diagram);
        return diagramOptimum_;
    }

    /// Whether a decision diagram is tried if the tree of a part grows large.
    [[nodiscard]] bool mayUseDiagram(const Part& part) const {
        return part.size() < options_.hard && options_.nodes > options_.nodesBeforeDiagram;
    }

    [[nodiscard]] PartOptions optionsOf(const Part& part) const {
        PartOptions options = options_;
        options.best = 1;
        options.maxCost = infinity; // that of the whole graph counts
        // What smaller parts have left over, later ones get.
        const std::size_t left = options.work - std::min(result_.work, options.work);
        options.work = left / variablesLeft_ * part.size();
        options.gap /= static_cast<double>(parts_.size());
        if (!options_.start) options.large = PartOptions::never;
        if (part.size() >= options.large)
            options.nodes = 1;
        else if (mayUseDiagram(part))
            options.nodes = options_.nodesBeforeDiagram;
        return options;
    }

    /// Extends a graph of one part to a graph of the whole problem, and polishes it.
    [[nodiscard]] Assignment polish(const Part& part, const Assignment& best,
                                    const std::vector<double>& relaxedPart) const {
        Assignment graph = *options_.start;
        IdVector<VariableId, double> relaxed = result_.relaxed;
        for (std::size_t k = 0; k < part.size(); ++k) {
            graph[part[k]] = best[part[k]];
            relaxed[part[k]] = relaxedPart[k];
        }
        return options_.polish(graph, relaxed);
    }

    /// Adds what a search has found out about a part, other than its graph.
    void add(const Part& part, BranchAndBound& search) {
        if (options_.keepOpenParts && !search.complete())
            if (auto root = search.relaxedRoot())
                result_.openParts.push_back({std::move(*root), search.lowerBound()});
        result_.nodes += search.nodes();
        result_.work += search.work();
        result_.lowerBound += search.lowerBound();
        for (std::size_t k = 0; k < search.rootPresence().size() && options_.start; ++k)
            result_.relaxed[part[k]] = search.rootPresence()[k];
        result_.complete = result_.complete && search.complete();
    }

    SearchState& state_;
    const OptimumOptions& options_;
    const Control& control_;
    OptimumResult& result_;
    Assignment graph_;
    std::vector<Part> parts_;
    std::size_t variablesLeft_ = 0; ///< of the parts that have not been searched
    bool diagramIsTried_ = false;
    std::optional<Assignment> diagramOptimum_;
};

/// Finds several graphs. Choices of different parts combine, so all parts are searched together.
void searchTogether(SearchState& state, const OptimumOptions& options, const Control& control,
                    OptimumResult& result) {
    std::vector<VariableId> variables;
    for (const VariableId v : state.problem().variables())
        if (state.isFree(v)) variables.push_back(v);
    PartOptions together = options;
    together.maxCost -= result.lowerBound;
    together.gap = 0;
    together.large = PartOptions::never;
    BranchAndBound search(state, variables, together, control);
    if (options.start) search.offer(*options.start);
    search.run();
    result.nodes = search.nodes();
    result.work = search.work();
    result.lowerBound += search.lowerBound();
    result.complete = search.complete();
    for (const auto& [cost, graph] : search.incumbents().graphs())
        result.graphs.push_back(graph);
}

/// \return false if `visit` returned false, or a limit ended it
template <class Visit>
bool rank(const Diagram& diagram, const OptimumOptions& options, const Control& control, const Visit& visit) {
    if (options.best == 1) { // without sorting all graphs of the same cost
        const double cost = diagram.fixedCost + cheapestPaths(diagram)[diagram.root];
        const auto graph = cheapestGraph(diagram);
        return !graph || cost > options.maxCost + Incumbents::tolerance || visit(*graph);
    }
    std::size_t left = options.best;
    bool ended = false;
    const auto visitNext = [&](double cost, const Assignment& graph) {
        if (left-- == 0 || cost > options.maxCost + Incumbents::tolerance) return false;
        ended = !visit(graph);
        return !ended;
    };
    return forEachRankedGraph(diagram, visitNext, control) && !ended;
}

} // namespace

OptimumResult findOptimum(const Problem& problem, const OptimumOptions& options, const Control& control) {
    SearchState state(problem);
    if (!state.consistent()) return {{}, infinity, true, 0, 0, {}, {}};
    OptimumResult result;
    result.lowerBound = costOf(problem, state.assignment()); // of what is decided already
    if (state.freeVariables() == 0 || options.best == 1)
        PartsSearch(state, options, control, result).run();
    else
        searchTogether(state, options, control, result);
    return result;
}

OptimumResult findBest(const Problem& problem, const OptimumOptions& options, const Control& control) {
    if (options.best == 1) return findOptimum(problem, options, control);
    const auto diagram = buildDiagram(problem, smallDiagram, control);
    if (!diagram) return findOptimum(problem, options, control);
    OptimumResult result;
    result.lowerBound = diagram->fixedCost + cheapestPaths(*diagram)[diagram->root];
    result.complete = rank(*diagram, options, control, [&](const Assignment& graph) {
        result.graphs.push_back(graph);
        return true;
    });
    return result;
}

bool forEachBest(const Problem& problem, const OptimumOptions& options,
                 const std::function<bool(const Assignment&)>& visit, const Control& control) {
    if (const auto diagram = buildDiagram(problem, smallDiagram, control))
        return rank(*diagram, options, control, visit);
    const OptimumResult found = findOptimum(problem, options, control);
    return std::ranges::all_of(found.graphs, visit) && found.complete;
}

} // namespace qm

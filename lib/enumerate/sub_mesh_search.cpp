#include "enumerate/sub_mesh_search.h"

#include "base/error.h"
#include "enumerate/coordinates.h"
#include "enumerate/count.h"
#include "enumerate/depth_first.h"
#include "enumerate/diagram_count.h"
#include "enumerate/diagram_walk.h"
#include "enumerate/incumbents.h"
#include "enumerate/optimum.h"
#include "enumerate/ranked_graphs.h"
#include "enumerate/tracks.h"

#include <cmath>
#include <set>
#include <string>

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

CoordinateMethod coordinateMethod(Method method) {
    switch (method) {
    case Method::naive:
        return CoordinateMethod::naive;
    case Method::bounds:
        return CoordinateMethod::bounds;
    default:
        return CoordinateMethod::improved;
    }
}

[[noreturn]] void refuse(int subMesh) {
    throw Error("sub-mesh " + std::to_string(subMesh), "no graph obeys the constraints",
                "take some out of /constraints");
}

} // namespace

SubMeshSearch::SubMeshSearch(const QuadMesh& mesh, const BaseComplex& complex,
                             const std::vector<double>& edgeCosts, const SubMeshes& subMeshes,
                             const EnumerationOptions& options)
    : mesh_(mesh), complex_(complex), edgeCosts_(edgeCosts), options_(options),
      space_(makeSearchSpace(mesh, complex, edgeCosts, subMeshes, options.constraints,
                             cornerCost(options.cost.terms))) {
    for (int label = 0; label < subMeshes.count; ++label)
        sureCosts_.push_back(space_.cornerCost == 0
                                 ? 0
                                 : space_.cornerCost *
                                       static_cast<double>(countSureCorners(mesh, subMeshes.labels, label)));
}

Problem SubMeshSearch::problem(int subMesh) const {
    Problem problem = subMeshProblem(space_, subMesh, ownArcs(space_, subMesh),
                                     std::vector(space_.graph.arcs.size(), false));
    problem.gaps = options_.graphClass == GraphClass::motorcycle;
    return problem;
}

/// Of the variables of a sub-mesh's problem.
double SubMeshSearch::maxCost(int subMesh) const {
    return options_.maxCost - sureCosts_[at(subMesh)];
}

MotorcycleGraph SubMeshSearch::graph(const Problem& problem, int subMesh,
                                     const Assignment& assignment) const {
    std::vector<bool> present(space_.graph.arcs.size(), false);
    const Walkers walkers = walkersOf(space_, subMesh, present);
    apply(problem, assignment, present);
    MotorcycleGraph result = problem.gaps
                                 ? graphOf(mesh_, complex_, space_.graph, present, edgeCosts_, walkers)
                                 : tMeshOf(mesh_, complex_, space_.graph, present, edgeCosts_);
    if (space_.cornerCost != 0) result.cost = costOf(problem, assignment) + sureCosts_[at(subMesh)];
    return result;
}

SubMeshGraphs SubMeshSearch::search(int subMesh, const Control& control, std::atomic<bool>& complete) const {
    const Problem problem = this->problem(subMesh);
    SubMeshGraphs result = options_.method == Method::optimum
                               ? searchOptimum(problem, subMesh, control, complete)
                               : searchCoordinates(problem, subMesh, control, complete);
    if (!result.graphs.empty()) result.cost = result.graphs.front().cost;
    return result;
}

bool SubMeshSearch::forEach(int subMesh, bool ranked, const Visit& visit, const Control& control) const {
    const Problem problem = this->problem(subMesh);
    const auto hand = [&](const Assignment& assignment) {
        return visit(graph(problem, subMesh, assignment)) && !control.stopRequested();
    };
    const double limit = maxCost(subMesh) + Incumbents::tolerance;
    const auto diagram = buildDiagram(problem, smallDiagram, control);
    if (ranked && diagram) {
        std::size_t left = options_.best;
        bool ended = false;
        forEachRankedGraph(*diagram, [&](double cost, const Assignment& assignment) {
            if (cost > limit || left-- == 0) return false;
            ended = !hand(assignment);
            return !ended;
        });
        return !ended;
    }
    if (ranked) {
        std::atomic<bool> complete = true;
        for (const MotorcycleGraph& each : searchOptimum(problem, subMesh, control, complete).graphs)
            if (!visit(each)) return false;
        return complete;
    }
    if (diagram) return walkDiagramUpTo(*diagram, limit, hand);
    return forEachAssignment(
        problem, [&] { return limit; }, [&](const SearchState& state) { return hand(state.assignment()); });
}

/// Every particle straight on in turn: a graph to begin with, however hard the search.
std::optional<Assignment> SubMeshSearch::simpleGraph(const Problem& problem, int subMesh) const {
    if (!space_.demands.empty()) return std::nullopt;
    std::vector<bool> present(space_.graph.arcs.size(), false);
    goStraight(space_, subMesh, present);
    Assignment assignment(problem.domains.size(), 0);
    assignment[static_cast<std::size_t>(problem.in())] = 1;
    for (int v = 0; v < problem.variables(); ++v)
        assignment[static_cast<std::size_t>(v)] =
            present[problem.arcs[static_cast<std::size_t>(v)].first.idx()] ? 1 : 0;
    return assignment;
}

SubMeshGraphs SubMeshSearch::searchOptimum(const Problem& problem, int subMesh, const Control& control,
                                           std::atomic<bool>& complete) const {
    OptimumOptions options;
    options.best = options_.best;
    options.maxCost = maxCost(subMesh);
    options.gap = options_.gap;
    options.start = simpleGraph(problem, subMesh);
    const OptimumResult found = findBest(problem, options, control);
    SubMeshGraphs result;
    for (const Assignment& assignment : found.graphs)
        result.graphs.push_back(graph(problem, subMesh, assignment));
    if (std::isfinite(found.lowerBound)) result.lowerBound = found.lowerBound + sureCosts_[at(subMesh)];
    // The bound sums what the search summed, in another order than the tracks' costs.
    if (!result.graphs.empty() && result.lowerBound)
        result.lowerBound = std::min(*result.lowerBound, result.graphs.front().cost);
    if (result.graphs.empty() && found.complete && std::isinf(options_.maxCost)) refuse(subMesh);
    if (!found.complete) complete = false;
    countAndDraw(problem, subMesh, result, control, complete);
    return result;
}

/// What only a diagram of all graphs can tell.
void SubMeshSearch::countAndDraw(const Problem& problem, int subMesh, SubMeshGraphs& result,
                                 const Control& control, std::atomic<bool>& complete) const {
    const bool limited = std::isfinite(options_.maxCost);
    if (options_.count && !limited) result.count = countGraphs(problem, control);
    if (options_.sample > 0 || (options_.count && limited)) {
        const auto diagram = buildDiagram(problem, diagramNodes, control);
        if (diagram && options_.count && limited)
            result.count = countUpTo(*diagram, maxCost(subMesh) + Incumbents::tolerance, control);
        if (diagram)
            for (const Assignment& drawn : drawGraphs(*diagram, options_.sample, options_.seed))
                result.samples.push_back(graph(problem, subMesh, drawn));
        else if (options_.sample > 0)
            complete = false;
    }
    if (options_.count && !result.count) complete = false;
}

SubMeshGraphs SubMeshSearch::searchCoordinates(const Problem& problem, int subMesh, const Control& control,
                                               std::atomic<bool>& complete) const {
    std::set<Assignment> seen;
    Incumbents incumbents(options_.best, maxCost(subMesh));
    const auto visit = [&](const Assignment& assignment) {
        if (seen.insert(assignment).second) incumbents.offer(costOf(problem, assignment), assignment);
        return true;
    };
    const bool finished =
        forEachCoordinateVector(problem, coordinateMethod(options_.method), visit, control.stopRequested);
    if (!finished) complete = false;
    SubMeshGraphs result;
    for (const auto& [cost, assignment] : incumbents.graphs())
        result.graphs.push_back(graph(problem, subMesh, assignment));
    if (finished && !incumbents.empty()) result.lowerBound = result.graphs.front().cost;
    if (finished) result.count = BigCount(seen.size());
    return result;
}

} // namespace qm

#include "enumerate/sub_mesh_search.h"

#include "base/at.h"
#include "base/error.h"
#include "base/parallel.h"
#include "enumerate/diagram/count_and_draw.h"
#include "enumerate/diagram/walk.h"
#include "enumerate/paper/coordinates.h"
#include "enumerate/state/depth_first.h"
#include "enumerate/state/incumbents.h"
#include "layout/corners.h"
#include "layout/tracks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>

namespace qm {
namespace {

std::optional<std::string> decimal(const std::optional<BigCount>& count) {
    return count ? std::optional(count->str()) : std::nullopt;
}

CoordinateMethod coordinateMethod(Method method) {
    if (method == Method::naive) return CoordinateMethod::naive;
    return method == Method::bounds ? CoordinateMethod::bounds : CoordinateMethod::improved;
}

} // namespace

SubMeshSearch::SubMeshSearch(const SearchedMesh& searched, const EnumerationOptions& options)
    : searched_(searched), options_(options),
      edgeCosts_(edgeCosts(searched.mesh, searched.dihedralAngles, options.cost, searched.constraints)),
      space_(makeSearchSpace(searched.mesh, searched.complex, {edgeCosts_, cornerCost(options.cost.terms)},
                             searched.subMeshes, searched.constraints)) {
    fixedCosts_.assign(at(searched.subMeshes.count), 0);
    if (space_.cornerCost == 0) return;
    const Corners corners(searched.mesh, searched.subMeshes);
    for (const SubMeshId subMesh : searched.subMeshes.ids())
        fixedCosts_[subMesh] = space_.cornerCost * static_cast<double>(corners.fixed(subMesh));
}

SubMeshSearch::Task SubMeshSearch::task(SubMeshId subMesh) const {
    Task task{subMesh, ownSpace(space_, subMesh), {}, {}};
    const PresentArcs none(task.space.graph.arcs.size(), false);
    task.problem = subMeshProblem(task.space, subMesh, ownArcs(task.space, subMesh), none);
    task.walkers = walkersOf(task.space, subMesh, none);
    task.problem.gaps = options_.graphClass == GraphClass::motorcycle;
    return task;
}

/// The highest cost of the variables in a sub-mesh's problem.
double SubMeshSearch::maxCost(SubMeshId subMesh) const {
    return options_.maxCost - fixedCosts_[subMesh];
}

MotorcycleGraph SubMeshSearch::graph(const Task& task, const Assignment& assignment) const {
    const ArcGraph& arcs = task.space.graph;
    PresentArcs present(arcs.arcs.size(), false);
    apply(task.problem, assignment, present);
    MotorcycleGraph result =
        task.problem.gaps
            ? graphOf({searched_.mesh, searched_.complex, arcs}, present, edgeCosts_, task.walkers)
            : tMeshOf({searched_.mesh, searched_.complex, arcs}, present, edgeCosts_);
    if (space_.cornerCost != 0) result.cost = costOf(task.problem, assignment) + fixedCosts_[task.subMesh];
    return result;
}

SubMeshSearch::Found SubMeshSearch::search(SubMeshId subMesh, const Control& control) const {
    const Task task = this->task(subMesh);
    const bool optimum = options_.method == Method::optimum;
    Found found = optimum ? searchOptimum(task, control) : searchCoordinates(task, control);
    if (!found.subMesh.graphs.empty())
        found.subMesh.cost = found.subMesh.graphs.front().cost;
    else if (found.complete && std::isinf(options_.maxCost))
        throw Error("sub-mesh " + std::to_string(subMesh.value()), "no graph obeys the constraints",
                    "Take some out of /constraints");
    if (optimum) countAndDraw(task, found, control);
    return found;
}

bool SubMeshSearch::list(SubMeshId subMesh, ListedGraphs which, const GraphListing& listing,
                         const Control& control) const {
    const Task task = this->task(subMesh);
    // To write a graph takes far longer than to find it, so they are found in batches and written on all
    // threads, some at a time.
    constexpr std::size_t some = 64;
    const std::size_t batch = control.jobs > 1 ? 8 * some * control.jobs : some;
    std::vector<Assignment> waiting;
    bool isWanted = true;
    const auto handOver = [&] {
        const auto part = [&](std::size_t k) {
            return std::span(waiting).subspan(k * some, std::min(some, waiting.size() - k * some));
        };
        std::vector<std::string> texts((waiting.size() + some - 1) / some);
        parallelFor(texts.size(), control.jobs, [&](std::size_t k) {
            for (const Assignment& assignment : part(k))
                listing.append(subMesh, graph(task, assignment), texts[k]);
        });
        for (std::size_t k = 0; k < texts.size() && isWanted; ++k)
            isWanted = listing.take(texts[k], part(k).size()) && !control.stopRequested();
        waiting.clear();
    };
    const auto put = [&](const Assignment& assignment) {
        waiting.push_back(assignment);
        if (waiting.size() == batch) handOver();
        return isWanted;
    };
    const bool found =
        which == ListedGraphs::best ? findRanked(task, put, control) : find(task, put, control);
    if (isWanted) handOver();
    return found && isWanted;
}

/// Visits every graph.
/// \return false if `visit` or a limit ended the search early
bool SubMeshSearch::find(const Task& task, const std::function<bool(const Assignment&)>& visit,
                         const Control& control) const {
    const double limit = maxCost(task.subMesh) + Incumbents::tolerance;
    if (const auto diagram = buildDiagram(task.problem, smallDiagram, control))
        return walkDiagram(*diagram, limit, visit);
    return forEachAssignment(
        task.problem, [&] { return limit; },
        [&](const SearchState& state) { return visit(state.assignment()); }, control);
}

/// Visits the best graphs, cheapest first.
bool SubMeshSearch::findRanked(const Task& task, const std::function<bool(const Assignment&)>& visit,
                               const Control& control) const {
    return forEachBest(task.problem, optimumOptions(task), visit, control);
}

/// A search begins with a graph, however hard it is: that of particles that go straight on one after the
/// other.
OptimumOptions SubMeshSearch::optimumOptions(const Task& task) const {
    OptimumOptions options;
    options.best = options_.best;
    options.maxCost = maxCost(task.subMesh);
    if (space_.demands.empty()) {
        PresentArcs present(task.space.graph.arcs.size(), false);
        goStraight(task.space, task.subMesh, present);
        options.start = assignmentOf(task.problem, present);
    }
    return options;
}

SubMeshSearch::Found SubMeshSearch::searchOptimum(const Task& task, const Control& control) const {
    OptimumOptions options = optimumOptions(task);
    options.gap = options_.gap;
    const OptimumResult optimum = findBest(task.problem, options, control);
    Found found{{}, optimum.complete};
    auto& [cost, lowerBound, count, graphs, samples] = found.subMesh;
    for (const Assignment& assignment : optimum.graphs)
        graphs.push_back(graph(task, assignment));
    if (std::isfinite(optimum.lowerBound)) lowerBound = optimum.lowerBound + fixedCosts_[task.subMesh];
    // The bound adds costs in another order than the tracks' costs do, and proofs hold up to the tolerance
    // only.
    if (!graphs.empty() && lowerBound && *lowerBound >= graphs.front().cost - Incumbents::tolerance)
        lowerBound = graphs.front().cost;
    return found;
}

/// Adds the results that need a diagram of all graphs.
void SubMeshSearch::countAndDraw(const Task& task, Found& found, const Control& control) const {
    const bool limited = std::isfinite(options_.maxCost);
    auto& [subMesh, complete] = found;
    if (options_.count && !limited) subMesh.count = decimal(countGraphs(task.problem, control));
    if (options_.sample > 0 || (options_.count && limited)) {
        const auto diagram = buildDiagram(task.problem, diagramNodes, control);
        if (diagram && options_.count && limited)
            subMesh.count =
                decimal(countUpTo(*diagram, maxCost(task.subMesh) + Incumbents::tolerance, control));
        if (diagram)
            for (const Assignment& drawn : drawGraphs(*diagram, options_.sample, options_.seed))
                subMesh.samples.push_back(graph(task, drawn));
        else if (options_.sample > 0)
            complete = false;
    }
    if (options_.count && !subMesh.count) complete = false;
}

SubMeshSearch::Found SubMeshSearch::searchCoordinates(const Task& task, const Control& control) const {
    std::set<Assignment> seen; // these methods visit most graphs several times
    const double limit = maxCost(task.subMesh);
    Incumbents incumbents(options_.best, limit);
    const auto visit = [&](const Assignment& assignment) {
        const double cost = costOf(task.problem, assignment);
        if (cost <= limit + Incumbents::tolerance && seen.insert(assignment).second)
            incumbents.offer(cost, assignment);
        return true;
    };
    Found found{{},
                forEachCoordinateVector(task.problem, coordinateMethod(options_.method), visit,
                                        control.stopRequested)};
    for (const auto& [cost, assignment] : incumbents.graphs())
        found.subMesh.graphs.push_back(graph(task, assignment));
    if (!found.complete) return found;
    if (!incumbents.empty()) found.subMesh.lowerBound = found.subMesh.graphs.front().cost;
    found.subMesh.count = std::to_string(seen.size());
    return found;
}

} // namespace qm

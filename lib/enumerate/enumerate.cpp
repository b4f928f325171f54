#include "enumerate/enumerate.h"

#include "base/deadline.h"
#include "base/error.h"
#include "base/parallel.h"
#include "enumerate/coordinates.h"
#include "enumerate/count.h"
#include "enumerate/depth_first.h"
#include "enumerate/incumbents.h"
#include "enumerate/optimum.h"
#include "enumerate/plain.h"
#include "enumerate/search_space.h"
#include "enumerate/tracks.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <string>

namespace qm {
namespace {

/// Reports finished pieces out of a known number.
class Finished {
public:
    Finished(const Control& control, std::size_t total) : control_(control), total_(total) {}
    void one() {
        const std::lock_guard lock(mutex_);
        control_.progress(static_cast<double>(++done_) / static_cast<double>(total_));
    }

private:
    const Control& control_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

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

class SubMeshSearch {
public:
    SubMeshSearch(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& edgeCosts,
                  const SearchSpace& space, const EnumerationOptions& options)
        : mesh_(mesh), complex_(complex), edgeCosts_(edgeCosts), space_(space), options_(options) {}

    [[nodiscard]] Problem problem(int subMesh) const {
        return subMeshProblem(space_, subMesh, ownArcs(space_, subMesh),
                              std::vector(space_.graph.arcs.size(), false));
    }

    [[nodiscard]] SubMeshGraphs search(int subMesh, const Control& control,
                                       std::atomic<bool>& complete) const {
        const Problem problem = this->problem(subMesh);
        SubMeshGraphs result = options_.method == Method::optimum
                                   ? searchOptimum(problem, subMesh, control, complete)
                                   : searchCoordinates(problem, subMesh, control, complete);
        if (!result.graphs.empty()) result.cost = result.graphs.front().cost;
        return result;
    }

    [[nodiscard]] MotorcycleGraph graph(const Problem& problem, int subMesh,
                                        const Assignment& assignment) const {
        std::vector<bool> present(space_.graph.arcs.size(), false);
        const Walkers walkers = walkersOf(space_, subMesh, present);
        apply(problem, assignment, present);
        return graphOf(mesh_, complex_, space_.graph, present, edgeCosts_, walkers);
    }

private:
    /// Every particle straight on in turn: a graph to begin with, however hard the search.
    [[nodiscard]] std::optional<Assignment> simpleGraph(const Problem& problem, int subMesh) const {
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

    SubMeshGraphs searchOptimum(const Problem& problem, int subMesh, const Control& control,
                                std::atomic<bool>& complete) const {
        OptimumOptions options;
        options.best = options_.best;
        options.maxCost = options_.maxCost;
        options.gap = options_.gap;
        options.start = simpleGraph(problem, subMesh);
        const OptimumResult found = findOptimum(problem, options, control);
        SubMeshGraphs result;
        for (const Assignment& assignment : found.graphs)
            result.graphs.push_back(graph(problem, subMesh, assignment));
        if (std::isfinite(found.lowerBound)) result.lowerBound = found.lowerBound;
        // The bound sums what the search summed, in another order than the tracks' costs.
        if (!result.graphs.empty() && result.lowerBound)
            result.lowerBound = std::min(*result.lowerBound, result.graphs.front().cost);
        if (result.graphs.empty() && found.complete && std::isinf(options_.maxCost)) refuse(subMesh);
        if (!found.complete) complete = false;
        if (options_.count) {
            result.count = countGraphs(problem, control);
            if (!result.count) complete = false;
        }
        return result;
    }

    SubMeshGraphs searchCoordinates(const Problem& problem, int subMesh, const Control& control,
                                    std::atomic<bool>& complete) const {
        std::set<Assignment> seen;
        Incumbents incumbents(options_.best, options_.maxCost);
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
        if (finished && !incumbents.empty()) result.lowerBound = incumbents.bestCost();
        if (finished) result.count = BigCount(seen.size());
        return result;
    }

    [[noreturn]] static void refuse(int subMesh) {
        throw Error("sub-mesh " + std::to_string(subMesh), "no motorcycle graph obeys the constraints",
                    "take some out of /constraints");
    }

    const QuadMesh& mesh_;
    const BaseComplex& complex_;
    const std::vector<double>& edgeCosts_;
    const SearchSpace& space_;
    const EnumerationOptions& options_;
};

/// The plain motorcycle graph is one process on the whole mesh.
Enumeration enumeratePlain(const QuadMesh& mesh, const BaseComplex& complex,
                           const std::vector<double>& edgeCosts, const SubMeshes& subMeshes) {
    if (subMeshes.count != 1)
        throw Error("/cut", "the plain motorcycle graph is traced on the whole mesh", "leave qm-cut out");
    const MotorcycleGraph graph = plainMotorcycleGraph(mesh, complex, edgeCosts);
    Enumeration result;
    result.subMeshes.push_back({graph.cost, std::nullopt, std::nullopt, {graph}});
    return result;
}

} // namespace

Enumeration enumerateGraphs(const QuadMesh& mesh, const BaseComplex& complex,
                            const std::vector<double>& dihedralAngles, const SubMeshes& subMeshes,
                            const EnumerationOptions& options, const Control& control) {
    const std::vector<double> costs = edgeCosts(dihedralAngles, options.cost);
    Enumeration result;
    if (options.method == Method::plain) {
        result = enumeratePlain(mesh, complex, costs, subMeshes);
    } else {
        const SearchSpace space = makeSearchSpace(mesh, complex, costs, subMeshes, options.constraints);
        const SubMeshSearch search(mesh, complex, costs, space, options);
        const auto count = static_cast<std::size_t>(subMeshes.count);
        const Deadline deadline(control, options.timeLimit);
        Finished finished(control, count);
        std::atomic<bool> complete = true;
        result.subMeshes.resize(count);
        parallelFor(count, control.jobs, [&](std::size_t i) {
            result.subMeshes[i] = search.search(static_cast<int>(i), deadline.control(), complete);
            finished.one();
        });
        result.complete = complete;
    }
    result.cost = options.cost;
    result.method = options.method;
    result.count = BigCount(1);
    for (const SubMeshGraphs& subMesh : result.subMeshes)
        if (result.count && subMesh.count)
            *result.count *= *subMesh.count;
        else
            result.count.reset();
    return result;
}

bool forEachGraph(const QuadMesh& mesh, const BaseComplex& complex, const std::vector<double>& dihedralAngles,
                  const SubMeshes& subMeshes, const EnumerationOptions& options,
                  const std::function<bool(int subMesh, const MotorcycleGraph& graph)>& visit,
                  const Control& control) {
    const std::vector<double> costs = edgeCosts(dihedralAngles, options.cost);
    const SearchSpace space = makeSearchSpace(mesh, complex, costs, subMeshes, options.constraints);
    const SubMeshSearch search(mesh, complex, costs, space, options);
    const Deadline deadline(control, options.timeLimit);
    const Control limited = deadline.control();
    for (int i = 0; i < subMeshes.count; ++i) {
        const Problem problem = search.problem(i);
        const bool finished = forEachAssignment(
            problem, [&] { return options.maxCost + Incumbents::tolerance; },
            [&](const SearchState& state) {
                return visit(i, search.graph(problem, i, state.assignment())) && !limited.stopRequested();
            });
        if (!finished) return false;
        control.progress(static_cast<double>(i + 1) / static_cast<double>(subMeshes.count));
    }
    return true;
}

} // namespace qm

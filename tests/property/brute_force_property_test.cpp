// Compares the search on random small meshes with trying everything, by code that shares nothing with it: the
// number of graphs, the minimum and the best graphs must agree.
#include "base/at.h"
#include "basecomplex/arc_graph.h"
#include "check/mesh/neighbourhoods.h"
#include "enumerate/diagram/count_and_draw.h"
#include "enumerate/optimum/optimum.h"
#include "support/brute_force.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace qm::test {
namespace {

constexpr int wanted = 200;
constexpr std::size_t best = 9;
constexpr std::uint64_t maxSteps = 10000;

/// The cost of the edge between two vertices: any function that both programs can compute.
double costOf(int one, int other) {
    const auto [less, more] = std::minmax(one, other);
    return std::sin(12.9898 * less + 78.233 * more + 1);
}

/// The costs of all graphs, ascending; nothing if trying everything would take too long.
std::optional<std::vector<double>> triedOut(const QuadMesh& mesh) {
    const check::Neighbourhoods around(check::checkedMesh(mesh));
    check::EdgeCosts costs{std::vector(static_cast<std::size_t>(around.edges()), 0.0), {}};
    for (int step = 0; step < around.steps(); ++step)
        costs.cost[at(around.edge(step))] = costOf(around.from(step), around.to(step));
    const BruteForce all = bruteForce(around, check::traceLines(around, {}).front(), costs, maxSteps);
    if (!all.complete) return std::nullopt;
    std::vector<double> result;
    for (const auto& [edges, graph] : all.graphs)
        result.push_back(graph.cost);
    std::ranges::sort(result);
    return result;
}

Problem problemOf(const QuadMesh& mesh) {
    std::vector<double> costs;
    for (const auto edge : mesh.edges()) {
        const auto halfedge = mesh.halfedge_handle(edge, 0);
        costs.push_back(
            costOf(mesh.from_vertex_handle(halfedge).idx(), mesh.to_vertex_handle(halfedge).idx()));
    }
    const BaseComplex complex = buildBaseComplex(mesh);
    const ArcGraph graph = buildArcGraph(mesh, complex);
    const auto arcCosts = sumOverArcs(mesh, graph, complex, costs);
    return makeProblem({graph, arcCosts, {}, {}, {}, {}});
}

void expectCosts(const Problem& problem, const std::vector<Assignment>& found,
                 const std::vector<double>& costs) {
    ASSERT_EQ(found.size(), std::min(best, costs.size()));
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_NEAR(costOf(problem, found[k]), costs[k], 1e-6);
}

TEST(BruteForceProperty, RandomMeshesHaveTheSameGraphs) {
    int compared = 0;
    for (unsigned number = 0; compared < wanted && number < 40 * wanted; ++number) {
        std::mt19937 random(number);
        const auto mesh = randomMesh(random);
        if (!mesh || buildBaseComplex(*mesh).separatrices.empty()) continue;
        const auto costs = triedOut(*mesh);
        if (!costs || costs->size() == 1) continue;
        SCOPED_TRACE(number);
        ++compared;
        const Problem problem = problemOf(*mesh);
        EXPECT_EQ(countGraphs(problem), BigCount(costs->size()));
        const OptimumResult one = findOptimum(problem, {});
        ASSERT_EQ(one.graphs.size(), 1U);
        EXPECT_NEAR(costOf(problem, one.graphs.front()), costs->front(), 1e-6);
        OptimumOptions options;
        options.best = best;
        expectCosts(problem, findOptimum(problem, options).graphs, *costs); // by branch and bound
        expectCosts(problem, findBest(problem, options).graphs, *costs);    // by a diagram
    }
    EXPECT_EQ(compared, wanted);
}

} // namespace
} // namespace qm::test

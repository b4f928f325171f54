// Compares the exact search with trying everything, on random problems that are small enough.
#include "base/infinity.h"
#include "enumerate/diagram/cheapest_graph.h"
#include "enumerate/optimum/optimum.h"
#include "enumerate/state/depth_first.h"
#include "program/integer_program.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

namespace qm::test {
namespace {

constexpr unsigned cases = 400;
constexpr std::size_t maxGraphs = 3000;

struct Case {
    ArcGraph graph;
    IdVector<ArcId, double> costs;
    Problem whole;
    std::vector<Assignment> graphs; ///< of the whole problem, cheapest first
};

/// All graphs, cheapest first; nothing if there are too many.
std::optional<std::vector<Assignment>> tryEverything(const Problem& problem) {
    std::vector<Assignment> graphs;
    const bool finished = forEachAssignment(
        problem, [] { return infinity; },
        [&](const SearchState& state) {
            graphs.push_back(state.assignment());
            return graphs.size() <= maxGraphs;
        });
    if (!finished) return std::nullopt;
    std::ranges::sort(graphs, {},
                      [&](const Assignment& graph) { return std::pair(costOf(problem, graph), graph); });
    return graphs;
}

/// A random cost; whole numbers make many ties, others none.
double drawCost(std::mt19937& random, bool whole) {
    return whole ? std::uniform_int_distribution(-2, 2)(random)
                 : std::uniform_real_distribution<double>(-1, 1)(random);
}

std::optional<Case> drawCase(unsigned number) {
    std::mt19937 random(number + 1000);
    const auto mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    const BaseComplex complex = buildBaseComplex(*mesh, randomSeeds(*mesh, 3, random));
    Case drawn;
    drawn.graph = buildArcGraph(*mesh, complex);
    for (std::size_t arc = 0; arc < drawn.graph.arcs.size(); ++arc)
        drawn.costs.push_back(drawCost(random, number % 2 == 0));
    drawn.whole = makeProblem({drawn.graph, drawn.costs, {}, {}, {}, {}});
    drawn.whole.gaps = number % 3 != 0;
    auto graphs = tryEverything(drawn.whole);
    if (!graphs || graphs->empty()) return std::nullopt;
    drawn.graphs = std::move(*graphs);
    return drawn;
}

/// A random window in one of the graphs: some arcs are free, all others fixed; at some junctions tracks may
/// end.
Problem drawWindow(const Case& drawn, std::mt19937& random) {
    PresentArcs present(drawn.graph.arcs.size(), false);
    const Assignment& graph = drawn.graphs[random() % drawn.graphs.size()];
    apply(drawn.whole, graph, present);
    std::vector<ArcId> freeArcs;
    for (const ArcId arc : present.ids())
        if (random() % 2 == 0) freeArcs.push_back(arc);
    IdVector<JunctionId, SubMeshId> labels;
    for (std::size_t junction = 0; junction < drawn.graph.junctions.size(); ++junction)
        labels.emplace_back(random() % 5 == 0 ? 1 : 0);
    Problem problem = makeProblem({drawn.graph,
                                   drawn.costs,
                                   ArcStates(present, freeArcs),
                                   {},
                                   OpenJunctions(labels, SubMeshId(0)),
                                   {}});
    problem.gaps = drawn.whole.gaps;
    return problem;
}

void expectOptimum(const Problem& problem, const std::vector<Assignment>& all) {
    for (const std::size_t cut : {0U, 300U}) {
        OptimumOptions options;
        options.cut = cut;
        const OptimumResult result = findOptimum(problem, options);
        EXPECT_TRUE(result.complete);
        ASSERT_EQ(result.graphs.size(), all.empty() ? 0U : 1U);
        if (all.empty()) return;
        const double minCost = costOf(problem, all.front());
        EXPECT_NEAR(costOf(problem, result.graphs.front()), minCost, 1e-6);
        EXPECT_NEAR(result.lowerBound, minCost, 1e-6);
        EXPECT_NE(std::ranges::find(all, result.graphs.front()), all.end());
    }
}

void expectBest(const Problem& problem, const std::vector<Assignment>& all, std::size_t best,
                double maxCost) {
    OptimumOptions options;
    options.best = best;
    options.maxCost = maxCost;
    options.cut = 0;
    const OptimumResult result = findOptimum(problem, options);
    EXPECT_TRUE(result.complete);
    const auto cheap = static_cast<std::size_t>(std::ranges::count_if(
        all, [&](const Assignment& graph) { return costOf(problem, graph) <= maxCost + 1e-9; }));
    ASSERT_EQ(result.graphs.size(), std::min(best, cheap));
    for (std::size_t k = 0; k < result.graphs.size(); ++k) {
        EXPECT_NEAR(costOf(problem, result.graphs[k]), costOf(problem, all[k]), 1e-6);
        EXPECT_NE(std::ranges::find(all, result.graphs[k]), all.end());
        EXPECT_EQ(std::ranges::count(result.graphs, result.graphs[k]), 1);
    }
    EXPECT_LE(result.lowerBound, all.empty() ? infinity : costOf(problem, all.front()) + 1e-6);
}

TEST(Optimum, IsTheCheapestOfAllGraphs) {
    int tried = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        SCOPED_TRACE(number);
        ++tried;
        expectOptimum(drawn->whole, drawn->graphs);
    }
    EXPECT_GE(tried, 100);
}

TEST(Optimum, SeveralAreTheCheapestWithTiesAndLimits) {
    for (unsigned number = 0; number < cases; number += 2) {
        const auto drawn = drawCase(number + number % 4 / 2);
        if (!drawn) continue;
        SCOPED_TRACE(number);
        expectBest(drawn->whole, drawn->graphs, 5, infinity);
        const std::size_t middle = std::min<std::size_t>(drawn->graphs.size() - 1, 3);
        expectBest(drawn->whole, drawn->graphs, 20, costOf(drawn->whole, drawn->graphs[middle]) + 1e-3);
    }
}

TEST(Diagram, ItsCheapestGraphIsTheFirstOfItsTies) {
    int tied = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        const auto diagram = buildDiagram(drawn->whole, 1'000'000);
        ASSERT_TRUE(diagram) << number;
        EXPECT_EQ(cheapestGraph(*diagram), drawn->graphs.front()) << number;
        if (drawn->graphs.size() > 1 &&
            costOf(drawn->whole, drawn->graphs[0]) == costOf(drawn->whole, drawn->graphs[1]))
            ++tied;
    }
    EXPECT_GT(tied, 20);
}

TEST(Problem, HasNothingFreeOnLinesThatAreNotGiven) {
    std::optional<Case> drawn;
    for (unsigned number = 0; !drawn || drawn->whole.chains.empty(); ++number)
        drawn = drawCase(number);
    const Problem none = makeProblem({drawn->graph, drawn->costs, {}, {}, {}, {}, 0, std::vector<LineId>{}});
    EXPECT_TRUE(none.chains.empty());
    EXPECT_TRUE(none.crossings.empty());
}

TEST(Optimum, WindowsWithWallsAndOpenEnds) {
    int tried = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const auto drawn = drawCase(number);
        if (!drawn || !drawn->whole.gaps) continue; // a T-mesh may contain pieces that no particle reaches
        SCOPED_TRACE(number);
        std::mt19937 random(number);
        for (int window = 0; window < 3; ++window) {
            const Problem problem = drawWindow(*drawn, random);
            const auto all = tryEverything(problem);
            if (!all) continue;
            ++tried;
            expectOptimum(problem, *all);
            expectBest(problem, *all, 4, infinity);
        }
    }
    EXPECT_GE(tried, 300);
}

TEST(Optimum, StartsFromAKnownGraphAndStopsWhenAsked) {
    for (unsigned number = 0; number < cases; number += 5) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        SCOPED_TRACE(number);
        OptimumOptions options;
        options.start = drawn->graphs.back();
        const OptimumResult full = findOptimum(drawn->whole, options);
        const double minCost = costOf(drawn->whole, drawn->graphs.front());
        EXPECT_NEAR(costOf(drawn->whole, full.graphs.front()), minCost, 1e-6);
        Control control;
        control.stopRequested = [] { return true; };
        const OptimumResult stopped = findOptimum(drawn->whole, options, control);
        ASSERT_EQ(stopped.graphs.size(), 1U);
        EXPECT_LE(stopped.lowerBound, minCost + 1e-6);
    }
}

TEST(Optimum, IsTheSameEveryTime) {
    for (unsigned number = 0; number < cases; number += 5) {
        const auto drawn = drawCase(number);
        if (!drawn) continue;
        EXPECT_EQ(findOptimum(drawn->whole, {}).graphs, findOptimum(drawn->whole, {}).graphs);
    }
}

TEST(IntegerProgram, KnowsWhatASolutionCostsAndWhetherItIsAllowed) {
    IntegerProgram program;
    program.costs = {2, -1, 4};
    IntegerProgram::Row row;
    row.lower = 1;
    row.upper = 2;
    row.add(ColumnId(0), 1);
    row.add(ColumnId(2), 3);
    program.rows.push_back(row);
    EXPECT_EQ(program.cost({1, 1, 0}), 1);
    EXPECT_EQ(program.cost({0, 1, 1}), 3);
    EXPECT_TRUE(program.allows({1, 1, 0}));
    EXPECT_FALSE(program.allows({0, 1, 0})) << "below the row";
    EXPECT_FALSE(program.allows({0, 0, 1})) << "above it";
    EXPECT_TRUE(program.allows({1 - 1e-10, 0, 0})) << "but for rounding";
    EXPECT_TRUE(isFractional(0.5));
    EXPECT_FALSE(isFractional(1e-9) || isFractional(1 - 1e-9) || isFractional(1));
}

} // namespace
} // namespace qm::test

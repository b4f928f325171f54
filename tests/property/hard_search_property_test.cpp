// Searches where the relaxation leaves much undecided: lines that cross each other all over a torus, with
// positive costs everywhere.
#include "enumerate/optimum/optimum.h"
#include "enumerate/paper/plain_graph.h"
#include "enumerate/sub_mesh/search_space.h"
#include "layout/cost.h"
#include "layout/tracks.h"
#include "program/decomposition_bound.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace qm::test {
namespace {

constexpr unsigned cases = 60;
constexpr double longTime = 1e9;

struct Torus {
    ArcGraph graph;
    Problem problem;
    Assignment plain;   ///< the plain motorcycle graph
    double minCost = 0; ///< lowest cost of all graphs
};

Torus drawTorus(unsigned number) {
    std::mt19937 random(number);
    const QuadMesh mesh = quadMesh(torus(14, 15));
    std::uniform_real_distribution<double> cost(0.1, 1);
    std::vector<double> costs(mesh.n_edges());
    std::ranges::generate(costs, [&] { return cost(random); });
    const BaseComplex complex = buildBaseComplex(mesh, randomSeeds(mesh, 60, random));
    Torus drawn{buildArcGraph(mesh, complex), {}, {}, 0};
    const auto arcCosts = sumOverArcs(mesh, drawn.graph, complex, costs);
    drawn.problem = makeProblem({drawn.graph, arcCosts, {}, {}, {}, {}});
    drawn.plain = assignmentOf(drawn.problem, presentArcs({mesh, complex, drawn.graph},
                                                          plainMotorcycleGraph(mesh, complex, costs).tracks));
    drawn.minCost = costOf(drawn.problem, findOptimum(drawn.problem, {}).graphs.front());
    return drawn;
}

TEST(HardSearchProperty, DivesAndPolishingEndInTheOptimum) {
    std::size_t polished = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const Torus drawn = drawTorus(number);
        OptimumOptions options;
        options.hard = 1;
        options.cut = 1;
        options.start = drawn.plain;
        options.polish = [&](const Assignment& graph, const IdVector<VariableId, double>& relaxed) {
            EXPECT_EQ(relaxed.size(), graph.size());
            EXPECT_GE(costOf(drawn.problem, graph), drawn.minCost - 1e-6);
            ++polished;
            return graph;
        };
        const OptimumResult found = findOptimum(drawn.problem, options);
        ASSERT_TRUE(found.complete);
        EXPECT_NEAR(costOf(drawn.problem, found.graphs.front()), drawn.minCost, 1e-6) << "case " << number;
        EXPECT_NEAR(found.lowerBound, drawn.minCost, 1e-6) << "case " << number;
    }
    EXPECT_GT(polished, cases / 10);
}

TEST(HardSearchProperty, DecompositionBoundsLieBetweenTheRelaxationAndTheOptimum) {
    std::size_t raised = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const Torus drawn = drawTorus(number);
        OptimumOptions rootOnly;
        rootOnly.nodes = 1;
        rootOnly.keepOpenParts = true;
        OptimumResult root = findOptimum(drawn.problem, rootOnly);
        double clusters = root.lowerBound, whole = root.lowerBound, free = root.lowerBound;
        for (OpenPart& part : root.openParts) {
            const auto gain = [&part](std::size_t columns) {
                return std::max(0.0, decompositionBound(part.relaxed, {columns, columns, longTime}) -
                                         part.lowerBound);
            };
            clusters += gain(40);
            whole += gain(1'000'000);
            std::ranges::fill(part.relaxed.duals, 0);
            free += gain(10);
        }
        EXPECT_LE(clusters, drawn.minCost + 1e-6) << "case " << number;
        EXPECT_LE(free, drawn.minCost + 1e-6) << "case " << number;
        EXPECT_NEAR(whole, drawn.minCost, 1e-6) << "case " << number;
        if (clusters > root.lowerBound + 1e-6) ++raised;
    }
    EXPECT_GT(raised, 3U);
}

/// The bound of a search that treats all parts as large, improved by the optima of the parts left open.
double boundWithOpenParts(const OptimumResult& found) {
    double bound = found.lowerBound;
    for (const OpenPart& part : found.openParts)
        bound += std::max(0.0, decompositionBound(part.relaxed, {1'000'000, 1'000'000, longTime}) -
                                   part.lowerBound);
    return bound;
}

TEST(HardSearchProperty, LargePartsAreRelaxedFromGradientsToTheSameBound) {
    double ofRoots = 0, ofLarge = 0;
    std::size_t cheaper = 0, told = 0;
    for (unsigned number = 0; number < cases; ++number) {
        const Torus drawn = drawTorus(number);
        OptimumOptions options;
        options.start = drawn.plain;
        options.nodes = 1;
        ofRoots += findOptimum(drawn.problem, options).lowerBound;
        options.large = 1;
        options.keepOpenParts = true;
        options.near = [&](double lowerBound) {
            ++told;
            EXPECT_LE(lowerBound, drawn.minCost + 1e-6) << "case " << number;
            return true;
        };
        const OptimumResult found = findOptimum(drawn.problem, options);
        EXPECT_EQ(found.complete, found.openParts.empty()) << "case " << number;
        const double cost = costOf(drawn.problem, found.graphs.front());
        const double ofPlain = costOf(drawn.problem, drawn.plain);
        EXPECT_LE(cost, ofPlain + 1e-9) << "case " << number;
        EXPECT_GE(cost, drawn.minCost - 1e-6) << "case " << number;
        if (cost < ofPlain - 1e-6) ++cheaper;
        EXPECT_LE(found.lowerBound, drawn.minCost + 1e-6) << "case " << number;
        ofLarge += found.lowerBound;
        EXPECT_NEAR(boundWithOpenParts(found), drawn.minCost, 1e-6) << "case " << number;
    }
    EXPECT_NEAR(ofLarge, ofRoots, 1e-3 * ofRoots);
    EXPECT_GT(cheaper, cases / 2);
    EXPECT_GT(told, cases / 2) << "but for parts that need no relaxation";
}

TEST(HardSearchProperty, LargePartsAreBoundedWhereverTheyAreStopped) {
    for (unsigned number = 0; number < cases; ++number) {
        const Torus drawn = drawTorus(number);
        OptimumOptions options;
        options.start = drawn.plain;
        options.large = 1;
        options.keepOpenParts = true;
        double last = -longTime;
        for (const int questions : {0, 1, 20, 200, 500, 1000, 2000}) {
            int left = questions;
            Control control;
            control.stopRequested = [&left] { return left-- <= 0; };
            const OptimumResult found = findOptimum(drawn.problem, options, control);
            EXPECT_LE(found.lowerBound, drawn.minCost + 1e-6) << "case " << number << ", " << questions;
            EXPECT_EQ(found.complete, found.openParts.empty()) << "case " << number << ", " << questions;
            EXPECT_LE(boundWithOpenParts(found), drawn.minCost + 1e-6)
                << "case " << number << ", " << questions;
            EXPECT_GE(found.lowerBound, last - 1e-6) << "case " << number << ", " << questions;
            last = found.lowerBound;
        }
    }
}

TEST(HardSearchProperty, DecompositionBoundsAreTrueWhereverTheClockEndsThem) {
    for (unsigned number = 0; number < cases; ++number) {
        const Torus drawn = drawTorus(number);
        OptimumOptions rootOnly;
        rootOnly.nodes = 1;
        rootOnly.keepOpenParts = true;
        const OptimumResult root = findOptimum(drawn.problem, rootOnly);
        for (const double seconds : {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2}) {
            double bound = root.lowerBound;
            for (const OpenPart& part : root.openParts)
                bound += std::max(0.0, decompositionBound(part.relaxed, {1'000'000, 1'000'000, seconds}) -
                                           part.lowerBound);
            EXPECT_LE(bound, drawn.minCost + 1e-6) << "case " << number << ", " << seconds << " s";
        }
    }
}

} // namespace
} // namespace qm::test

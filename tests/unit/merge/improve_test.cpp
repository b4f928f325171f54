#include "base/infinity.h"
#include "enumerate/paper/plain_graph.h"
#include "layout/cost.h"
#include "layout/tracks.h"
#include "merge/across_cut.h"
#include "merge/graph_improver.h"
#include "merge/improve.h"
#include "mesh/dihedral.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

namespace qm {
namespace {

TEST(BoundBelow, TakesRoundingForWhatItIs) {
    EXPECT_EQ(boundBelow(-3, 5), -3);
    EXPECT_EQ(boundBelow(5 + 1e-9, 5), 5);
    EXPECT_EQ(boundBelow(-1e5 + 1e-3, -1e5), -1e5);
}

TEST(BoundBelow, IsAFaultWhereAGraphIsCheaper) {
    EXPECT_THROW((void)boundBelow(208.46, 205.11), std::logic_error);
    EXPECT_THROW((void)boundBelow(5.001, 5), std::logic_error);
    EXPECT_THROW((void)boundBelow(1e50, 5), std::logic_error);
}

/// A part with random costs and its plain motorcycle graph.
struct PlainCase {
    explicit PlainCase(unsigned number, int edges = 3, std::size_t seeds = 6)
        : mesh(test::quadMesh(test::polycube(test::bump(), edges))) {
        std::mt19937 random(number);
        complex = buildBaseComplex(mesh, test::randomSeeds(mesh, seeds, random));
        std::uniform_real_distribution<double> cost(-1, 2);
        costs.resize(mesh.n_edges());
        std::ranges::generate(costs, [&] { return cost(random); });
        space = makeSearchSpace(mesh, complex, {costs}, {}, {});
        present =
            presentArcs({mesh, complex, space.graph}, plainMotorcycleGraph(mesh, complex, costs).tracks);
    }

    QuadMesh mesh;
    BaseComplex complex;
    std::vector<double> costs;
    SearchSpace space;
    PresentArcs present;
};

TEST(MoveCuts, MakesGraphsCheaperAndLeavesThemValid) {
    int cheaper = 0;
    for (unsigned number = 0; number < 20; ++number) {
        const PlainCase plain(number);
        const WindowResult moved = moveCuts(plain.space, plain.present, 40, {});
        EXPECT_TRUE(test::isMotorcycleGraph(plain.space.graph, moved.present)) << number;
        const double before = costOf(plain.space, plain.present), after = costOf(plain.space, moved.present);
        EXPECT_LE(after, before + 1e-9) << number;
        cheaper += after < before - 1e-9 ? 1 : 0;
    }
    EXPECT_GT(cheaper, 5);
}

TEST(MoveCuts, ReportsProgressOnTheThreadOfTheCaller) {
    const PlainCase plain(1, 15, 150);
    Control control;
    control.jobs = 4;
    double last = 0;
    control.progress = [&, caller = std::this_thread::get_id()](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_GE(fraction, last);
        last = fraction;
    };
    const WindowResult moved = moveCuts(plain.space, plain.present, 5, {}, control);
    EXPECT_GT(moved.windows, 10U);
    EXPECT_GT(last, 0);
    EXPECT_LE(last, 1);
}

TEST(SearchWhole, FindsTheCheapestGraphAndItsBound) {
    for (unsigned number = 0; number < 20; ++number) {
        const PlainCase plain(number);
        const auto whole = searchWhole(plain.space, plain.present);
        ASSERT_TRUE(whole) << number;
        EXPECT_TRUE(test::isMotorcycleGraph(plain.space.graph, whole->present)) << number;
        const Problem problem = makeProblem(wholeInput(plain.space));
        const double cheapest = costOf(problem, findOptimum(problem, {}).graphs.front());
        EXPECT_LE(whole->lowerBound, cheapest + 1e-6) << number;
        EXPECT_TRUE(whole->proven) << number;
        EXPECT_NEAR(costOf(problem, assignmentOf(problem, whole->present)), cheapest, 1e-6) << number;
    }
}

TEST(SearchWhole, RelaxesOnlyTheRootOfLargerMeshes) {
    const PlainCase larger(1, 15, 150);
    ASSERT_GT(makeProblem(wholeInput(larger.space)).arcs.size(), 2500U);
    const auto whole = searchWhole(larger.space, larger.present);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(test::isMotorcycleGraph(larger.space.graph, whole->present));
    const double cost = costOf(larger.space, whole->present);
    EXPECT_LT(cost, costOf(larger.space, larger.present) - 1);
    EXPECT_LE(whole->lowerBound, cost + 1e-6);
    EXPECT_FALSE(whole->relaxed.empty());
}

TEST(SearchWhole, ProvesLargeMeshesThatFallIntoSmallParts) {
    constexpr int holes = 32;
    test::Cells plate;
    for (int x = 0; x <= 2 * holes; ++x)
        for (int y = 0; y <= 2 * holes; ++y)
            if (x % 2 == 0 || y % 2 == 0) plate.push_back({x, y, 0});
    const QuadMesh mesh = test::quadMesh(test::polycube(plate));
    const BaseComplex complex = buildBaseComplex(mesh);
    const std::vector<double> costs = edgeCosts(dihedralAngles(mesh), {});
    const SearchSpace space = makeSearchSpace(mesh, complex, {costs}, {}, {});
    ASSERT_GT(makeProblem(wholeInput(space)).arcs.size(), 10000U);
    const PresentArcs present =
        presentArcs({mesh, complex, space.graph}, plainMotorcycleGraph(mesh, complex, costs).tracks);
    const auto whole = searchWhole(space, present);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(whole->proven);
    EXPECT_TRUE(test::isMotorcycleGraph(space.graph, whole->present));
    EXPECT_NEAR(costOf(space, whole->present), whole->lowerBound, 1e-6);
}

TEST(SearchWhole, LeavesLargeMeshesAlone) {
    const PlainCase fine(1, 60, 2000);
    ASSERT_GT(makeProblem(wholeInput(fine.space)).arcs.size(), 10000U);
    EXPECT_FALSE(searchWhole(fine.space, fine.present));
}

TEST(GraphImprover, TellsOfEveryCheaperGraphAndEndsWithTheOptimum) {
    for (unsigned number = 0; number < 10; ++number) {
        const PlainCase plain(number);
        double toldCost = 0, toldBound = 0;
        const KnownCost tell = [&](double cost, double lowerBound) {
            toldCost = cost;
            toldBound = lowerBound;
        };
        const Control control;
        KnownSoFar known(control, tell, costOf(plain.space, plain.present));
        EXPECT_FALSE(known.control().stopRequested());
        EXPECT_EQ(toldCost, costOf(plain.space, plain.present));
        EXPECT_EQ(toldBound, -infinity);

        GraphImprover improver(plain.space, plain.present, known);
        EXPECT_FALSE(improver.isLarge());
        improver.searchWindows({}, {}, control);
        EXPECT_GT(improver.result().windows, 0U);
        EXPECT_LE(improver.result().improvements, improver.result().windows);
        const OptimumResult found = improver.searchTree(control, control);
        EXPECT_TRUE(found.complete);
        EXPECT_TRUE(test::isMotorcycleGraph(plain.space.graph, improver.result().present));
        EXPECT_NEAR(costOf(plain.space, improver.result().present), found.lowerBound, 1e-6);
        known.setBound(found.lowerBound);
        EXPECT_FALSE(known.control().stopRequested());
        EXPECT_NEAR(toldCost, found.lowerBound, 1e-6);
        EXPECT_EQ(toldBound, found.lowerBound);
    }
}

TEST(GraphImprover, OnlyRelaxesLargeMeshes) {
    int bounded = 0;
    for (unsigned number = 0; number < 10; ++number) {
        const PlainCase plain(number);
        Control control;
        const KnownCost silent;
        KnownSoFar exact(control, silent, 0);
        const double optimum =
            GraphImprover(plain.space, plain.present, exact).searchTree(control, control).lowerBound;
        for (const unsigned jobs : {1U, 2U}) {
            control.jobs = jobs;
            double told = 0;
            const KnownCost tell = [&](double, double lowerBound) { told = lowerBound; };
            const double before = costOf(plain.space, plain.present);
            KnownSoFar known(control, tell, before);
            GraphImprover improver(plain.space, plain.present, known, 1);
            EXPECT_TRUE(improver.isLarge());
            const OptimumResult found = improver.searchTree(control, control);
            EXPECT_TRUE(found.openParts.empty());
            EXPECT_EQ(found.relaxed.size(), makeProblem(wholeInput(plain.space)).domains.size());
            improver.searchWindows(found.relaxed, {.patient = true}, control);
            EXPECT_TRUE(test::isMotorcycleGraph(plain.space.graph, improver.result().present));
            EXPECT_LE(costOf(plain.space, improver.result().present), before + 1e-9);
            EXPECT_LE(found.lowerBound, optimum + 1e-6);
            EXPECT_FALSE(known.control().stopRequested());
            EXPECT_LE(told, optimum + 1e-6) << "what gradients prove";
            if (told > -infinity) ++bounded;
        }
    }
    EXPECT_GT(bounded, 10);
}

} // namespace
} // namespace qm

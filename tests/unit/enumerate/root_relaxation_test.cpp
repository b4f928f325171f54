// The relaxations of nodes and of the root, the pool of rows, and a start near an optimum.
#include "base/infinity.h"
#include "enumerate/optimum/node_relaxation.h"
#include "enumerate/optimum/root_relaxation.h"
#include "enumerate/relaxation/near_start.h"
#include "program/coin.h"
#include "support/random_problem.h"

#include <coin/ClpSimplex.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace qm::test {
namespace {

/// A search that treats a whole problem as one part.
struct WholeSearch {
    explicit WholeSearch(const Problem& problem)
        : state(problem), part(state, freeVariables(state), PartOptions{}, control) {}

    [[nodiscard]] double costOf(const Assignment& graph) const {
        return part.cost.of([&](VariableId variable) { return graph[variable] == 1; });
    }
    /// Whether the graph agrees with all values fixed in the state.
    [[nodiscard]] bool allows(const Assignment& graph) const {
        return std::ranges::all_of(part.variables, [&](VariableId variable) {
            return state.isFree(variable) ||
                   (state.value(variable) == ArcState::in) == (graph[variable] == 1);
        });
    }

    Control control;
    SearchState state;
    PartSearch part;
};

/// Calls `test` with searches and the ascending costs of their graphs; skips searches with fewer than two
/// graphs.
template <class Function> int forEachSearch(const Function& test) {
    int searches = 0;
    for (unsigned number = 0; number < 150; ++number) {
        const auto drawn = randomProblem(number);
        if (!drawn || drawn->graphs.size() < 2) continue;
        SCOPED_TRACE(number);
        WholeSearch search(*drawn->problem);
        if (!search.part.columns.consistent()) continue;
        test(search, drawn->graphs);
        ++searches;
    }
    return searches;
}

TEST(NodeRelaxation, BoundsAllGraphsAndLeavesTheCheaperOnes) {
    int fixed = 0;
    const int searches = forEachSearch([&](WholeSearch& search, const std::vector<Assignment>& graphs) {
        const Assignment& known = graphs[graphs.size() / 2];
        search.part.incumbents.offer(search.costOf(known), known);
        const std::size_t before = freeVariables(search.state).size();
        double bound = -infinity;
        const RelaxedNode relaxed = relaxNode(search.part, bound);
        ASSERT_NE(relaxed, RelaxedNode::unfinished);
        for (const Assignment& graph : graphs) {
            if (search.costOf(graph) >= search.part.incumbents.cutoff()) continue;
            EXPECT_EQ(relaxed, RelaxedNode::solved);
            EXPECT_GE(search.costOf(graph), bound - 1e-6);
            EXPECT_TRUE(search.allows(graph));
        }
        fixed += freeVariables(search.state).size() < before ? 1 : 0;
    });
    EXPECT_GT(searches, 30);
    EXPECT_GT(fixed, 5);
}

TEST(RootRelaxation, FixesMoreWithEveryBetterGraph) {
    int tightened = 0;
    forEachSearch([&](WholeSearch& search, std::vector<Assignment> graphs) {
        RootRelaxation root(search.part);
        EXPECT_FALSE(root.isKnown());
        EXPECT_TRUE(root.tighten()) << "nothing is known that could contradict";
        double bound = -infinity;
        ASSERT_EQ(relaxNode(search.part, bound), RelaxedNode::solved);
        root.remember(bound);
        ASSERT_TRUE(root.isKnown());
        ASSERT_EQ(root.presence().size(), search.part.variables.size());
        for (std::size_t k = 0; k < root.presence().size(); ++k)
            EXPECT_EQ(root.presence()[k], search.part.present(search.part.variables[k]));
        std::ranges::sort(graphs, std::ranges::greater{},
                          [&](const Assignment& graph) { return search.costOf(graph); });
        std::size_t open = freeVariables(search.state).size();
        for (std::size_t best = 0; best < graphs.size(); ++best) {
            search.part.incumbents.offer(search.costOf(graphs[best]), graphs[best]);
            const bool isLeft = root.tighten();
            for (std::size_t k = best + 1; k < graphs.size(); ++k)
                if (search.costOf(graphs[k]) < search.part.incumbents.cutoff()) {
                    EXPECT_TRUE(isLeft);
                    EXPECT_TRUE(search.allows(graphs[k]));
                }
            if (!isLeft) break;
            const std::size_t nowOpen = freeVariables(search.state).size();
            EXPECT_LE(nowOpen, open);
            tightened += nowOpen < open ? 1 : 0;
            open = nowOpen;
        }
    });
    EXPECT_GT(tightened, 20);
}

TEST(RootRelaxation, ComesBackToItsState) {
    int decided = 0;
    forEachSearch([&](WholeSearch& search, const std::vector<Assignment>& graphs) {
        RootRelaxation root(search.part);
        double bound = -infinity;
        if (relaxNode(search.part, bound) != RelaxedNode::solved) return;
        root.remember(bound);
        const std::vector<VariableId> open = freeVariables(search.state);
        if (open.empty()) return;
        const ArcState value = arcState(graphs.front()[open.front()] == 1);
        (void)search.part.columns.take({open.front(), Decision::About::value, value});
        const Relaxation::Result again = root.solveAgain();
        EXPECT_EQ(freeVariables(search.state), open);
        EXPECT_EQ(again.kind, Relaxation::Result::Kind::solved);
        EXPECT_NEAR(again.bound, bound, 1e-6);
        ++decided;
    });
    EXPECT_GT(decided, 20);
}

TEST(RootRelaxation, IsBoundedByGradients) {
    const int searches = forEachSearch([](WholeSearch& search, const std::vector<Assignment>&) {
        RootRelaxation root(search.part);
        EXPECT_FALSE(root.takeNear());
        const double near = root.relaxNearly();
        root.startFromNear();
        EXPECT_EQ(root.presence().size(), search.part.variables.size());
        double bound = -infinity;
        ASSERT_EQ(relaxNode(search.part, bound), RelaxedNode::solved);
        EXPECT_LE(near, bound + 1e-6);
        EXPECT_TRUE(root.takeNear());
        EXPECT_FALSE(root.takeNear());
    });
    EXPECT_GT(searches, 30);
}

TEST(RowPool, HasTheSolverObeyRowsThatItWasNotGiven) {
    int lazy = 0;
    forEachSearch([&](WholeSearch& search, const std::vector<Assignment>&) {
        Relaxation& relaxation = search.part.relaxation;
        const auto solve = [&] { return relaxation.solve(search.part.columns, infinity, 100000); };
        const Relaxation::Result first = solve();
        ASSERT_EQ(first.kind, Relaxation::Result::Kind::solved);
        const std::size_t rows = relaxation.basis().size();
        relaxation.dropIdleRows();
        lazy += relaxation.basis().size() < rows ? 1 : 0;
        const Relaxation::Result again = solve();
        ASSERT_EQ(again.kind, Relaxation::Result::Kind::solved);
        EXPECT_NEAR(again.bound, first.bound, 1e-6);
        for (const Formulation::Row& row : search.part.formulation.rows) {
            const double sum = row.sum(relaxation.values());
            EXPECT_GE(sum, row.lower - 1e-5);
            EXPECT_LE(sum, row.upper + 1e-5);
        }
    });
    EXPECT_GT(lazy, 5);
}

/// A ring of 101 columns in which at least one of two neighbours must be 1; the relaxation sets all to one
/// half.
class NearStart : public ::testing::Test {
protected:
    static constexpr int columns = 101;

    NearStart() {
        solver.setLogLevel(0);
        solver.resize(0, columns);
        for (int k = 0; k < columns; ++k) {
            solver.setColumnBounds(k, 0, 1);
            solver.setObjectiveCoefficient(k, 1);
            near.program.costs.push_back(1);
            near.program.rows.push_back({{ColumnId(k), ColumnId((k + 1) % columns)}, {1, 1}, 1, infinity});
            rows.push_back(static_cast<std::size_t>(k));
            const std::vector<int> pair{k, (k + 1) % columns};
            const std::vector<double> ones{1, 1};
            solver.addRow(2, pair.data(), ones.data(), 1, COIN_DBL_MAX);
        }
        near.values.assign(columns, 0.49);
        near.duals.assign(columns, 0.51);
    }

    ClpSimplex solver;
    RelaxedProgram near;
    std::vector<std::size_t> rows;
};

TEST_F(NearStart, IsSoonAtTheOptimum) {
    solveFromNear(solver, near, rows);
    EXPECT_EQ(solver.status(), 0);
    EXPECT_NEAR(solver.objectiveValue(), columns / 2.0, 1e-9);
    EXPECT_LE(solver.numberIterations(), 5) << "the basis was that of the optimum already";
}

TEST_F(NearStart, StopsWhenItIsAskedTo) {
    near.values.assign(columns, 1);
    near.duals.assign(columns, 0);
    const int perturbation = solver.perturbation();
    Control stopped;
    stopped.stopRequested = [] { return true; };
    StopOnRequest handler(stopped);
    solver.passInEventHandler(&handler);
    solveFromNear(solver, near, rows);
    EXPECT_EQ(solver.status(), 5);
    EXPECT_EQ(solver.perturbation(), perturbation);
    stopped.stopRequested = [] { return false; };
    solver.primal();
    EXPECT_EQ(solver.status(), 0) << "nobody asks it to stop any more";
    EXPECT_NEAR(solver.objectiveValue(), columns / 2.0, 1e-9);
}

} // namespace
} // namespace qm::test

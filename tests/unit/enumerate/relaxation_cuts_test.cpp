// Rows of the relaxation: what remains of them when columns are fixed, the parts of the search for cuts, and
// that every graph satisfies all cuts.
#include "base/infinity.h"
#include "enumerate/relaxation/acyclic_graph.h"
#include "enumerate/relaxation/cuts.h"
#include "enumerate/relaxation/relaxation.h"
#include "enumerate/relaxation/row_pool.h"
#include "enumerate/relaxation/smallest_cut.h"
#include "support/random_problem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace qm::test {
namespace {

TEST(AcyclicGraph, LeavesOutWhatWouldCloseALoop) {
    constexpr std::size_t nodes = 9;
    for (unsigned number = 0; number < 100; ++number) {
        std::mt19937 random(number);
        AcyclicGraph graph(nodes);
        // Whether a node reaches another one or is the same.
        std::array<std::array<bool, nodes>, nodes> leads{};
        for (std::size_t k = 0; k < nodes; ++k)
            leads.at(k).at(k) = true;
        for (int edge = 0; edge < 60; ++edge) {
            const std::size_t from = random() % nodes, to = random() % nodes;
            const bool closesLoop = leads.at(to).at(from);
            ASSERT_EQ(graph.add(from, to), !closesLoop) << number << ": " << from << " to " << to;
            if (closesLoop) continue;
            for (auto& before : leads)
                for (std::size_t k = 0; k < nodes && before.at(from); ++k)
                    before.at(k) = before.at(k) || leads.at(to).at(k);
        }
    }
}

TEST(SmallestCut, IsTheSmallestOfAllCuts) {
    constexpr std::size_t nodes = 7, source = 0, sink = nodes - 1;
    for (unsigned number = 0; number < 200; ++number) {
        std::mt19937 random(number);
        std::array<std::array<double, nodes>, nodes> capacity{};
        SmallestCut cut(nodes);
        for (int edge = 0; edge < 25; ++edge) {
            const std::size_t from = random() % nodes, to = random() % nodes;
            const double added = static_cast<double>(random() % 5) / 4;
            capacity.at(from).at(to) += added;
            cut.addEdge(from, to, added);
        }
        const auto capacityOf = [&](const auto& isBefore) {
            double sum = 0;
            for (std::size_t from = 0; from < nodes; ++from)
                for (std::size_t to = 0; to < nodes; ++to)
                    if (isBefore(from) && !isBefore(to)) sum += capacity.at(from).at(to);
            return sum;
        };
        double min = infinity;
        for (unsigned set = 0; set < 1U << nodes; ++set)
            if ((set >> source & 1U) == 1 && (set >> sink & 1U) == 0)
                min = std::min(min, capacityOf([set](std::size_t node) { return (set >> node & 1U) == 1; }));
        cut.find(source, sink);
        EXPECT_NEAR(capacityOf([&](std::size_t node) { return cut.isBefore(node); }), min, 1e-6) << number;
    }
}

/// Random values, which violate many rows. Small values lose trails; many halves violate odd cycles.
ColumnValues drawValues(std::size_t columns, bool halves, std::mt19937& random) {
    ColumnValues values(columns);
    for (double& value : values)
        if (halves)
            value = random() % 8 == 0 ? 0 : 0.5;
        else
            value = random() % 3 == 0 ? 1 : static_cast<double>(random() % 5) / 8;
    return values;
}

/// Random values, 0 or 1, of all columns that agree with those fixed in the state.
ColumnValues drawCompletion(const ColumnState& columns, std::size_t count, std::mt19937& random) {
    ColumnValues values(count);
    for (const ColumnId column : values.ids()) {
        const ArcState known = columns.value(column);
        values[column] = known == ArcState::free ? static_cast<double>(random() % 2) : known == ArcState::in;
    }
    return values;
}

TEST(OpenRow, SaysWhatItsRowSaysOfEveryCompletion) {
    std::size_t open = 0, idle = 0;
    for (unsigned number = 0; number < 100; ++number) {
        const auto drawn = randomProblem(number);
        if (!drawn || drawn->graphs.empty()) continue;
        std::mt19937 random(number);
        SearchState state(*drawn->problem);
        const std::vector<VariableId> variables = freeVariables(state);
        const Formulation formulation = formulate(state, variables);
        ColumnState columns(state, formulation);
        if (!columns.consistent() || variables.empty()) continue;
        const VariableId fixed = variables[random() % variables.size()];
        const ArcState value = arcState(drawn->graphs.front()[fixed] == 1);
        ASSERT_TRUE(!state.isFree(fixed) || columns.take({fixed, Decision::About::value, value}));
        const ColumnValues values = drawCompletion(columns, formulation.costs.size(), random);
        IdVector<ColumnId, int> numberOf(values.size(), -1);
        std::vector<double> openValues;
        for (const ColumnId column : values.ids())
            if (columns.value(column) == ArcState::free) {
                numberOf[column] = static_cast<int>(openValues.size());
                openValues.push_back(values[column]);
            }
        for (const RowId id : formulation.rows.ids()) {
            const Formulation::Row& row = formulation.rows[id];
            const double sum = row.sum(values);
            const OpenRow left = openRow(formulation, id, columns, numberOf);
            if (left.columns.empty()) {
                EXPECT_TRUE(sum >= row.lower && sum <= row.upper) << number << ", row " << id.value();
                ++idle;
            } else {
                EXPECT_DOUBLE_EQ(left.sum(openValues.data()), sum) << number << ", row " << id.value();
                ++open;
            }
        }
    }
    EXPECT_GT(open, 100U);
    EXPECT_GT(idle, 100U);
}

TEST(RelaxationCuts, EveryGraphObeysThem) {
    std::size_t trails = 0, cycles = 0;
    for (unsigned number = 0; number < 200; ++number) {
        const auto drawn = randomProblem(number);
        if (!drawn) continue;
        SCOPED_TRACE(number);
        std::mt19937 random(number);
        SearchState state(*drawn->problem);
        if (!state.consistent()) continue;
        Formulation formulation = formulate(state, freeVariables(state));
        ColumnState columns(state, formulation);
        const PassGraph graph(state, formulation);
        for (int round = 0; round < 5; ++round) {
            const ColumnValues values = drawValues(formulation.costs.size(), round % 2 == 0, random);
            const std::vector<Formulation::Row> ofTrails = brokenTrails(graph, values, 0.003 * round);
            const std::vector<Formulation::Row> ofCycles = brokenOddCycles(graph, values);
            trails += ofTrails.size();
            cycles += ofCycles.size();
            for (const auto& rows : {ofTrails, ofCycles})
                for (const Formulation::Row& row : rows) {
                    const double sum = row.sum(values);
                    EXPECT_TRUE(sum < row.lower || sum > row.upper) << "it cuts off what it was made for";
                    formulation.rows.push_back(row);
                }
        }
        const Control control;
        Relaxation relaxation(formulation, columns, control);
        for (const Assignment& assignment : drawn->graphs) {
            const ColumnState::Mark mark = columns.mark();
            for (const VariableId v : drawn->problem->variables())
                if (state.isFree(v)) {
                    const ArcState value = arcState(assignment[v] == 1);
                    ASSERT_TRUE(columns.take({v, Decision::About::value, value}));
                }
            EXPECT_EQ(relaxation.solve(columns, infinity, 10000).kind, Relaxation::Result::Kind::solved);
            columns.undo(mark);
        }
    }
    EXPECT_GT(trails, 100U);
    EXPECT_GT(cycles, 100U);
}

} // namespace
} // namespace qm::test

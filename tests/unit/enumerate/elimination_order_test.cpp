#include "enumerate/diagram/elimination_order.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <gtest/gtest.h>

#include <optional>

namespace qm::test {
namespace {

/// Two beams joined by rungs: lines along the beams cross all others.
Cells ladder(int rungs) {
    Cells cells;
    for (int x = 0; x <= 2 * rungs; ++x)
        for (int y = 0; y < 3; ++y)
            if (y != 1 || x % 2 == 0) cells.push_back({x, y, 0});
    return cells;
}

TEST(EliminationOrder, DecidesEveryVariableOfLongLinesOnce) {
    const QuadMesh mesh = quadMesh(polycube(ladder(1000)));
    const ArcGraph graph = buildArcGraph(mesh, buildBaseComplex(mesh));
    const IdVector<ArcId, double> costs(graph.arcs.size(), 1);
    const Problem problem = makeProblem({graph, costs, {}, {}, {}, {}});
    const SearchState state(problem);
    const auto order = eliminationOrder(state); // takes a minute if its time is quadratic
    ASSERT_TRUE(order);
    IdVector<VariableId, int> decided(problem.domains.size(), 0);
    for (const Step& step : *order)
        if (step.variable.valid()) ++decided[step.variable];
    for (const VariableId variable : problem.variables())
        EXPECT_EQ(decided[variable], state.isFree(variable) ? 1 : 0);
}

} // namespace
} // namespace qm::test

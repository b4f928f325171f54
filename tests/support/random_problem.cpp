#include "support/random_problem.h"

#include "base/infinity.h"
#include "enumerate/state/depth_first.h"
#include "support/random_graph.h"

#include <random>

namespace qm::test {

std::optional<RandomProblem> randomProblem(unsigned number) {
    constexpr std::size_t maxGraphs = 300;
    std::mt19937 random(number);
    const auto mesh = randomMesh(random);
    if (!mesh) return std::nullopt;
    RandomProblem drawn;
    drawn.graph = buildArcGraph(*mesh, buildBaseComplex(*mesh, randomSeeds(*mesh, 3, random)));
    for (std::size_t arc = 0; arc < drawn.graph.arcs.size(); ++arc)
        drawn.costs.push_back(std::uniform_real_distribution<double>(-1, 2)(random));
    drawn.problem = makeProblem({drawn.graph, drawn.costs, {}, {}, {}, {}});
    forEachAssignment(
        *drawn.problem, [] { return infinity; },
        [&](const SearchState& state) {
            drawn.graphs.push_back(state.assignment());
            return drawn.graphs.size() < maxGraphs;
        });
    return drawn;
}

std::vector<VariableId> freeVariables(const SearchState& state) {
    std::vector<VariableId> variables;
    for (const VariableId variable : state.problem().variables())
        if (state.isFree(variable)) variables.push_back(variable);
    return variables;
}

} // namespace qm::test

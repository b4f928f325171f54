/// \file The exact search beside plain CBC, by the number of stairs.

#include "enumerate/optimum.h"

#include "basecomplex/arc_graph.h"
#include "bench/plain_cbc.h"
#include "bench/staircase.h"
#include "mesh/dihedral.h"

#include <benchmark/benchmark.h>

namespace qm::bench {
namespace {

Problem problem(const benchmark::State& state) {
    const QuadMesh mesh = staircase(static_cast<int>(state.range(0)), 2);
    const BaseComplex complex = buildBaseComplex(mesh);
    const ArcGraph graph = buildArcGraph(mesh, complex);
    const auto costs = sumOverArcs(mesh, graph, complex, edgeCosts(dihedralAngles(mesh), {}));
    return makeProblem({graph, costs, std::vector(graph.arcs.size(), ArcState::free), {}, {}, {}});
}

void exactOptimum(benchmark::State& state) {
    const Problem searched = problem(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(findOptimum(searched, {}));
    state.counters["variables"] = searched.variables();
}

void plainCbc(benchmark::State& state) {
    const Problem searched = problem(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(solveWithPlainCbc(searched, 60));
    state.counters["variables"] = searched.variables();
}

BENCHMARK(exactOptimum)->Arg(4)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);
BENCHMARK(plainCbc)->Arg(4)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace qm::bench

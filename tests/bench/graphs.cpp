/// \file All graphs: how fast they are listed and counted, and how much faster than by the paper's
/// algorithms.

#include "base/parallel.h"
#include "basecomplex/arc_graph.h"
#include "enumerate/coordinates.h"
#include "enumerate/count.h"
#include "enumerate/diagram_walk.h"
#include "mesh/dihedral.h"
#include "support/polycube.h"
#include "support/random_graph.h"

#include <atomic>
#include <benchmark/benchmark.h>

namespace qm::bench {
namespace {

Problem problemOf(const QuadMesh& mesh) {
    const BaseComplex complex = buildBaseComplex(mesh);
    const ArcGraph graph = buildArcGraph(mesh, complex);
    const auto costs = sumOverArcs(mesh, graph, complex, edgeCosts(dihedralAngles(mesh), {}));
    return makeProblem({graph, costs, std::vector(graph.arcs.size(), ArcState::free), {}, {}, {}});
}

/// A square ring: a torus with 16 extraordinary vertices and 32 undirected separatrices, as the paper's has.
Problem ring() {
    testing::Cells cells;
    for (const auto& cell : testing::box(4, 5, 2))
        if (cell[0] == 0 || cell[0] == 3 || cell[1] == 0 || cell[1] == 4) cells.push_back(cell);
    return problemOf(testing::quadMesh(testing::polycube(cells, 2)));
}

/// A slab with cubes on it here and there: many graphs.
Problem studs(int count) {
    testing::Cells cells = testing::box(2 * count + 1, 3, 1);
    for (int k = 0; k < count; ++k)
        cells.push_back({2 * k + 1, 1, 1});
    return problemOf(testing::quadMesh(testing::polycube(cells, 2)));
}

/// Walks the whole diagram; every graph is looked at, on as many threads as the argument says.
void listing(benchmark::State& state) {
    const Problem problem = studs(4);
    const auto diagram = buildDiagram(problem, diagramNodes);
    std::uint64_t graphs = 0;
    for (auto _ : state) {
        std::atomic<std::uint64_t> sum = 0;
        const auto parts = splitDiagram(*diagram, 256);
        parallelFor(parts.size(), static_cast<unsigned>(state.range(0)), [&](std::size_t k) {
            Assignment assignment = parts[k].before;
            std::uint64_t seen = 0;
            const auto visit = [&seen](const Assignment& graph) {
                benchmark::DoNotOptimize(graph.data());
                return ++seen > 0;
            };
            walkDiagram(*diagram, parts[k].node, assignment, visit);
            sum += seen;
        });
        graphs = sum;
    }
    state.counters["graphs"] = static_cast<double>(graphs);
    state.counters["graphs/s"] =
        benchmark::Counter(static_cast<double>(graphs), benchmark::Counter::kIsIterationInvariantRate);
}

void counting(benchmark::State& state) {
    const Problem problem = studs(static_cast<int>(state.range(0)));
    BigCount count = 0;
    for (auto _ : state)
        count = countGraphs(problem).value_or(0);
    state.counters["junctions"] = static_cast<double>(problem.crossings.size());
    state.counters["graphs"] = count.convert_to<double>();
}

void ringByDiagram(benchmark::State& state) {
    const Problem problem = ring();
    BigCount count = 0;
    for (auto _ : state)
        count = countGraphs(problem).value_or(0);
    state.counters["junctions"] = static_cast<double>(problem.crossings.size());
    state.counters["graphs"] = count.convert_to<double>();
}

/// The paper's improved algorithm, and the one before it; ended after some vectors, which the rate tells.
void ringByCoordinates(benchmark::State& state) {
    const Problem problem = ring();
    constexpr std::uint64_t enough = 2'000'000;
    const auto method = state.range(0) == 0 ? CoordinateMethod::bounds : CoordinateMethod::improved;
    std::uint64_t vectors = 0;
    for (auto _ : state) {
        vectors = 0;
        benchmark::DoNotOptimize(forEachCoordinateVector(
            problem, method, [&](const Assignment&) { return ++vectors < enough; }, [] { return false; }));
    }
    state.counters["vectors"] = static_cast<double>(vectors);
    state.counters["all"] = vectors < enough ? 1 : 0;
}

BENCHMARK(listing)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(counting)->DenseRange(2, 10, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(ringByDiagram)->Unit(benchmark::kMillisecond);
BENCHMARK(ringByCoordinates)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace qm::bench

/// \file All graphs: how fast they are listed and counted, and how much faster than by the paper's
/// algorithms.

#include "base/parallel.h"
#include "bench/sample_models.h"
#include "bench/search_problem.h"
#include "enumerate/coordinates.h"
#include "enumerate/count.h"
#include "enumerate/diagram_walk.h"

#include <atomic>
#include <benchmark/benchmark.h>

namespace qm::bench {
namespace {

/// Walks the whole diagram; every graph is looked at, on as many threads as the argument says.
void listing(benchmark::State& state) {
    const Problem problem = searchProblem(studs(4));
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
    const Problem problem = searchProblem(studs(static_cast<int>(state.range(0))));
    BigCount count = 0;
    for (auto _ : state)
        count = countGraphs(problem).value_or(0);
    state.counters["junctions"] = static_cast<double>(problem.crossings.size());
    state.counters["graphs"] = count.convert_to<double>();
}

void torusByDiagram(benchmark::State& state) {
    const Problem problem = searchProblem(paperTorus());
    BigCount count = 0;
    for (auto _ : state)
        count = countGraphs(problem).value_or(0);
    state.counters["junctions"] = static_cast<double>(problem.crossings.size());
    state.counters["graphs"] = count.convert_to<double>();
}

/// The paper's improved algorithm, and the one before it, for some vectors: there are too many to wait for.
void torusByCoordinates(benchmark::State& state) {
    const Problem problem = searchProblem(paperTorus());
    constexpr std::uint64_t enough = 2'000'000;
    const auto method = state.range(0) == 0 ? CoordinateMethod::bounds : CoordinateMethod::improved;
    for (auto _ : state) {
        std::uint64_t vectors = 0;
        benchmark::DoNotOptimize(forEachCoordinateVector(
            problem, method, [&](const Assignment&) { return ++vectors < enough; }, [] { return false; }));
    }
    state.counters["vectors"] = static_cast<double>(enough);
}

BENCHMARK(listing)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(counting)->DenseRange(2, 10, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(torusByDiagram)->Unit(benchmark::kMillisecond);
BENCHMARK(torusByCoordinates)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace qm::bench

/// \file The exact search beside plain CBC, by the number of stairs.

#include "enumerate/optimum.h"

#include "bench/plain_cbc.h"
#include "bench/search_problem.h"
#include "bench/staircase.h"

#include <benchmark/benchmark.h>

namespace qm::bench {
namespace {

Problem problem(const benchmark::State& state) {
    return searchProblem(staircase(static_cast<int>(state.range(0)), 2));
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

/// \file Benchmarks of every stage's kernel by the number of quads. `make bench only=cut` runs those whose
/// names match.

#include "basecomplex/arc_graph.h"
#include "bench/staircase.h"
#include "cut/cut.h"
#include "enumerate/enumerate.h"
#include "features/features.h"
#include "layout/layout.h"
#include "mesh/dihedral.h"

#include <benchmark/benchmark.h>

namespace qm::bench {
namespace {

/// The inputs and outputs of the stages for a staircase.
struct Model {
    QuadMesh mesh;
    std::vector<double> angles = dihedralAngles(mesh);
    BaseComplex complex = buildBaseComplex(mesh);
};

Model model(const benchmark::State& state) {
    return {staircase(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)))};
}

void setSize(benchmark::State& state, const QuadMesh& mesh) {
    const auto quads = static_cast<double>(mesh.n_faces());
    state.counters["quads"] = quads;
    state.counters["quads/s"] = benchmark::Counter(quads, benchmark::Counter::kIsIterationInvariantRate);
}

/// Measures a function of a model.
template <class Work> void measure(benchmark::State& state, const Work& work) {
    const Model model = bench::model(state);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(work(model));
    setSize(state, model.mesh);
}

void dihedral(benchmark::State& state) {
    measure(state, [](const Model& model) { return dihedralAngles(model.mesh); });
}

void baseComplex(benchmark::State& state) {
    measure(state, [](const Model& model) { return buildBaseComplex(model.mesh); });
}

void arcGraph(benchmark::State& state) {
    measure(state, [](const Model& model) { return buildArcGraph(model.mesh, model.complex); });
}

void features(benchmark::State& state) {
    measure(state, [](const Model& model) { return findFeatures(model.mesh, model.angles, {}); });
}

void cut(benchmark::State& state) {
    measure(state, [](const Model& model) { return cutMesh(model.mesh, model.complex, model.angles, {}); });
}

void enumerateBy(Method method, benchmark::State& state) {
    EnumerationOptions options;
    options.method = method;
    measure(state, [&](const Model& model) {
        return enumerateGraphs({model.mesh, model.complex, model.angles, {}, {}}, options);
    });
}

void plainGraph(benchmark::State& state) {
    enumerateBy(Method::plain, state);
}

void optimum(benchmark::State& state) {
    enumerateBy(EnumerationOptions().method, state);
}

void layout(benchmark::State& state) {
    const Model model = bench::model(state);
    EnumerationOptions options;
    options.method = Method::plain;
    const Enumeration plain = enumerateGraphs({model.mesh, model.complex, model.angles, {}, {}}, options);
    const std::vector<Track>& tracks = plain.subMeshes.front().graphs.at(0).tracks;
    const std::vector<double> costs = edgeCosts(model.angles, {});
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(buildLayout(model.mesh, tracks, model.angles, costs));
    setSize(state, model.mesh);
}

// Arguments are stairs and refinement; the meshes have 540, 12,960 and 98,010 quads.
#define QM_KERNEL(function)                                                                                  \
    BENCHMARK(function)->Args({4, 3})->Args({5, 12})->Args({5, 33})->Unit(benchmark::kMillisecond)

QM_KERNEL(dihedral);
QM_KERNEL(baseComplex);
QM_KERNEL(arcGraph);
QM_KERNEL(features);
QM_KERNEL(cut);
QM_KERNEL(plainGraph);
QM_KERNEL(optimum);
QM_KERNEL(layout);

} // namespace
} // namespace qm::bench

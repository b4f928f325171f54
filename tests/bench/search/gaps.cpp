#include "bench/search/known_minima.h"
#include "bench/search/stopwatch.h"
#include "bench/search/tables.h"
#include "enumerate/enumerate.h"
#include "mesh/files/read_mesh.h"
#include "support/shared_files.h"

#include <cmath>
#include <cstdio>

namespace qm::bench {
namespace {

void printGap(const std::string& name, const QuadMesh& mesh, GraphClass graphClass, double seconds) {
    const BaseComplex complex = buildBaseComplex(mesh);
    EnumerationOptions options;
    options.graphClass = graphClass;
    options.timeLimit = seconds;
    Enumeration found;
    const double taken = secondsOf([&] {
        found = enumerateGraphs({mesh, complex, dihedralAngles(mesh), {}, {}}, options);
    });
    const SubMeshGraphs& whole = found.subMeshes.front();
    const double best = whole.cost.value_or(NAN), bound = whole.lowerBound.value_or(NAN);
    std::printf("%-24s %-10s %6zu %14.6f %14.6f %9.4f %9.2f\n", name.c_str(),
                graphClass == GraphClass::motorcycle ? "motorcycle" : "tmesh", complex.ordinaryJunctions,
                best, bound, 100 * (best - bound) / std::abs(best), taken);
}

} // namespace

void printGaps(const TableOptions& options) {
    if (options.gapSeconds <= 0) return;
    std::printf("Hard meshes, whole: the best graph and the bound after %.0f s\n", options.gapSeconds);
    std::printf("%-24s %-10s %6s %14s %14s %9s %9s\n", "mesh", "class", "n_j", "best", "bound", "gap %",
                "seconds");
    for (const char* name : hardMeshes()) {
        if (!std::regex_search(name, options.meshes)) continue;
        const auto bytes = test::sharedFile(std::string("dev/") + name);
        if (!bytes) continue;
        const QuadMesh mesh = readMesh(*bytes, name).mesh;
        for (const GraphClass graphClass : {GraphClass::motorcycle, GraphClass::tmesh})
            printGap(name, mesh, graphClass, options.gapSeconds);
    }
    std::puts("");
}

} // namespace qm::bench

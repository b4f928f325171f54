#include "base/infinity.h"
#include "bench/sample_models.h"
#include "bench/search/stopwatch.h"
#include "bench/search/tables.h"
#include "bench/search_problem.h"
#include "enumerate/diagram/walk.h"
#include "enumerate/paper/coordinates.h"

#include <cstdint>
#include <cstdio>

namespace qm::bench {
namespace {

struct Visited {
    std::uint64_t count = 0; ///< of graphs, or of coordinate vectors
    double seconds = 0;
    bool all = true;
};

Visited visitOurs(const Problem& problem) {
    Visited visited;
    visited.seconds = shortestOf(5, 1.0, [&] {
        visited.count = 0;
        const auto diagram = buildDiagram(problem, diagramNodes);
        const auto visit = [&](const Assignment&) { return ++visited.count > 0; };
        walkDiagram(*diagram, infinity, visit);
    });
    return visited;
}

Visited visitCoordinates(const Problem& problem, CoordinateMethod method, double maxSeconds) {
    Visited visited;
    const auto start = std::chrono::steady_clock::now();
    visited.seconds = secondsOf([&] {
        visited.all = forEachCoordinateVector(
            problem, method, [&](const Assignment&) { return ++visited.count > 0; },
            [&] {
                return std::chrono::steady_clock::now() - start > std::chrono::duration<double>(maxSeconds);
            });
    });
    return visited;
}

void print(const char* algorithm, const char* what, const Visited& visited, double ours) {
    const char* more = visited.all ? "" : ">";
    std::printf("%-12s %2s%13llu %-8s %2s%9.3f s %2s%8.0f times ours\n", algorithm, more,
                static_cast<unsigned long long>(visited.count), what, more, visited.seconds, more,
                visited.seconds / ours);
}

} // namespace

void printTorus(const TableOptions& options) {
    const QuadMesh mesh = paperTorus();
    const BaseComplex complex = buildBaseComplex(mesh);
    std::printf(
        "All graphs of a torus with %zu extraordinary vertices, %zu undirected separatrices, %zu vertices "
        "of the base complex (the paper's took 1525 s by B4, 44.5 s by B4')\n",
        complex.extraordinaryVertices.size(), complex.separatrices.size() / 2,
        complex.extraordinaryVertices.size() + complex.ordinaryJunctions);
    const Problem problem = searchProblem(mesh, complex);
    const Visited ours = visitOurs(problem);
    print("ours", "graphs", ours, ours.seconds);
    print("B4'", "vectors", visitCoordinates(problem, CoordinateMethod::improved, options.torusSeconds),
          ours.seconds);
    print("B4", "vectors", visitCoordinates(problem, CoordinateMethod::bounds, options.torusSeconds),
          ours.seconds);
    std::puts("");
}

} // namespace qm::bench

#include "base/infinity.h"
#include "bench/sample_models.h"
#include "bench/search/stopwatch.h"
#include "bench/search/tables.h"
#include "bench/search_problem.h"
#include "cli/tools/graph_line.h"
#include "enumerate/diagram/walk.h"
#include "enumerate/enumerate.h"

#include <cstdint>
#include <cstdio>

namespace qm::bench {
namespace {

constexpr double enough = 10; ///< seconds; longer measurements are not repeated

/// Visits every graph.
/// \return the number of graphs
std::uint64_t visitAll(const Problem& problem) {
    const auto diagram = buildDiagram(problem, diagramNodes);
    std::uint64_t graphs = 0;
    const auto visit = [&graphs](const Assignment& graph) {
        asm volatile("" : : "g"(graph.data()) : "memory"); // makes the compiler keep the values
        return ++graphs > 0;
    };
    walkDiagram(*diagram, infinity, visit);
    return graphs;
}

struct Written {
    std::uint64_t graphs = 0;
    std::uint64_t bytes = 0;
};

/// Writes every graph as a line of JSON and discards the text.
Written writeAll(const QuadMesh& mesh, unsigned jobs) {
    const BaseComplex complex = buildBaseComplex(mesh);
    const SeparatrixIndex separatrices(mesh, complex);
    Written written;
    const GraphListing listing{[&](SubMeshId subMesh, const MotorcycleGraph& graph, std::string& text) {
                                   appendGraphLine(mesh, separatrices, subMesh, graph, text);
                               },
                               [&](std::string_view text, std::size_t graphs) {
                                   written.graphs += graphs;
                                   written.bytes += text.size();
                                   return true;
                               }};
    Control control;
    control.jobs = jobs;
    listGraphs({mesh, complex, dihedralAngles(mesh), {}, {}}, {}, ListedGraphs::every, listing, control);
    return written;
}

/// The columns of one thread.
void printRate(const char* what, std::uint64_t graphs, double seconds) {
    const auto number = static_cast<double>(graphs);
    std::printf("%-24s %12.0f %9.3f %14.0f", what, number, seconds, number / seconds);
}

} // namespace

void printListing() {
    std::puts("All graphs, visited on one thread, and as JSON on one and on two");
    std::printf("%-24s %12s %9s %14s %9s %15s\n", "", "graphs", "one s", "graphs/s", "two s", "efficiency");
    const Problem problem = searchProblem(studs(4));
    std::uint64_t graphs = 0;
    const double one = shortestOf(3, enough, [&] { graphs = visitAll(problem); });
    printRate("visited (studs 4)", graphs, one);
    std::puts("");
    const QuadMesh mesh = studs(2);
    Written written;
    const double oneWrites = shortestOf(3, enough, [&] { written = writeAll(mesh, 1); });
    const double twoWrite = shortestOf(3, enough, [&] { written = writeAll(mesh, 2); });
    printRate("as JSON lines (studs 2)", written.graphs, oneWrites);
    std::printf(" %9.3f %13.0f %%\n", twoWrite, 100 * oneWrites / (2 * twoWrite));
    std::printf("JSON: %.0f bytes a line, %.0f MB/s on one thread\n\n",
                static_cast<double>(written.bytes) / static_cast<double>(written.graphs),
                static_cast<double>(written.bytes) / oneWrites / 1e6);
}

} // namespace qm::bench

#include "bench/sample_models.h"
#include "bench/search/known_minima.h"
#include "bench/search/stopwatch.h"
#include "bench/search/tables.h"
#include "bench/search_problem.h"
#include "enumerate/diagram/count_and_draw.h"
#include "mesh/files/read_mesh.h"
#include "support/shared_files.h"

#include <cstdio>
#include <string>

namespace qm::bench {
namespace {

constexpr std::size_t maxJunctions = 130;

/// \return whether the count equals the known one
bool printCount(const std::string& name, const QuadMesh& mesh, const std::string& known) {
    const BaseComplex complex = buildBaseComplex(mesh);
    const Problem problem = searchProblem(mesh, complex);
    std::optional<BigCount> count;
    const double seconds = shortestOf(3, 1.0, [&] { count = countGraphs(problem); });
    const std::string text = count ? count->str() : "?";
    const bool agrees = known.empty() || text == known;
    std::printf("%-24s %6zu %9.4f  %s%s\n", name.c_str(), complex.ordinaryJunctions, seconds, text.c_str(),
                known.empty() ? ""
                : agrees      ? "  as known"
                              : "  NOT AS KNOWN");
    return agrees;
}

} // namespace

bool printCounts(const TableOptions& options) {
    std::puts("How many graphs there are, exactly, without visiting them");
    std::printf("%-24s %6s %9s  %s\n", "mesh", "n_j", "seconds", "graphs");
    bool good = true;
    for (const int count : {4, 8, 12})
        if (const std::string name = "studs " + std::to_string(count);
            std::regex_search(name, options.meshes))
            good = printCount(name, studs(count), "") && good;
    for (const KnownMinima& known : knownMinima()) {
        if (known.ordinaryJunctions > maxJunctions || !std::regex_search(known.mesh, options.meshes))
            continue;
        if (const auto bytes = test::sharedFile(std::string("dev/") + known.mesh))
            good = printCount(known.mesh, readMesh(*bytes, known.mesh).mesh, known.graphs) && good;
    }
    std::puts("");
    return good;
}

} // namespace qm::bench

#include "bench/plain_cbc.h"
#include "bench/search/known_minima.h"
#include "bench/search/stopwatch.h"
#include "bench/search/tables.h"
#include "bench/search_problem.h"
#include "bench/staircase.h"
#include "enumerate/optimum/optimum.h"
#include "mesh/files/read_mesh.h"
#include "support/shared_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace qm::bench {
namespace {

constexpr double agree = 1e-5;   ///< costs that programs print or add in different orders
constexpr double minTime = 1e-3; ///< shorter times count as this long in ratios

/// The measurements of one problem.
struct Row {
    double ours = 0; ///< seconds
    double cbc = 0;
    double cost = 0;
    bool proven = false;
    bool cbcProven = false;
    bool agrees = true; ///< whether CBC's optimum is the same, if proven
};

Row compare(const Problem& problem, double cbcSeconds) {
    Row row;
    OptimumResult found;
    PlainCbcResult plain;
    row.ours = shortestOf(3, 1.0, [&] { found = findOptimum(problem, {}); });
    row.cbc = shortestOf(3, 1.0, [&] { plain = solveWithPlainCbc(problem, cbcSeconds); });
    row.cost = found.graphs.empty() ? NAN : costOf(problem, found.graphs.front());
    row.proven = found.complete && found.lowerBound >= row.cost - agree;
    row.cbcProven = plain.proven;
    row.agrees = !plain.proven || std::abs(plain.cost - row.cost) < agree * std::max(1.0, std::abs(row.cost));
    return row;
}

/// Prints rows and collects the final remarks.
class Table {
public:
    explicit Table(const TableOptions& options) : options_(options) {
        std::printf("%-24s %-10s %5s %6s %9s %9s %8s %14s  %s\n", "mesh", "class", "EV", "n_j", "ours s",
                    "CBC s", "ratio", "minimum", "");
    }

    void add(const std::string& name, const QuadMesh& mesh, const KnownMinima* known) {
        const BaseComplex complex = buildBaseComplex(mesh);
        for (const GraphClass graphClass : {GraphClass::motorcycle, GraphClass::tmesh}) {
            const bool gaps = graphClass == GraphClass::motorcycle;
            const Row row = compare(searchProblem(mesh, complex, graphClass), options_.cbcSeconds);
            std::string remark = row.proven ? "proven" : "NOT PROVEN";
            remark += row.cbcProven ? "" : ", CBC not";
            if (!row.agrees) remark += ", CBC DIFFERS";
            bool asKnown = true;
            if (known != nullptr) {
                const double minimum = gaps ? known->minimum : known->minimumTMesh;
                const double precision =
                    gaps
                        ? 2e-6
                        : known->precision * std::max(1.0, known->precision > 1e-5 ? std::abs(minimum) : 1.0);
                asKnown = std::abs(row.cost - minimum) <= precision &&
                          complex.extraordinaryVertices.size() == known->extraordinaryVertices &&
                          complex.ordinaryJunctions == known->ordinaryJunctions;
                remark += asKnown ? ", as known" : ", NOT AS KNOWN";
            }
            const double ratio = std::max(row.cbc, minTime) / std::max(row.ours, minTime);
            std::printf("%-24s %-10s %5zu %6zu %9.4f %9.4f %8.2f %14.6f  %s\n", name.c_str(),
                        gaps ? "motorcycle" : "tmesh", complex.extraordinaryVertices.size(),
                        complex.ordinaryJunctions, row.ours, row.cbc, ratio, row.cost, remark.c_str());
            logarithms_ += std::log(ratio);
            slower_ = std::max(slower_, row.ours - row.cbc);
            good_ = good_ && row.proven && row.agrees && asKnown;
            ++rows_;
        }
    }

    bool finish() const {
        std::printf("%d rows: CBC takes %.2f times as long in the geometric mean; ours is slower by %.3f s "
                    "at most\n\n",
                    rows_, std::exp(logarithms_ / std::max(1, rows_)), std::max(0.0, slower_));
        return good_;
    }

private:
    const TableOptions& options_;
    double logarithms_ = 0;
    double slower_ = 0;
    int rows_ = 0;
    bool good_ = true;
};

} // namespace

bool printOptima(const TableOptions& options) {
    std::printf(
        "The cheapest graph of whole meshes, proven, beside CBC on the plain formulation (limit %.0f s)\n",
        options.cbcSeconds);
    Table table(options);
    for (const int stairs : {4, 8, 12})
        if (const std::string name = "stairs " + std::to_string(stairs);
            std::regex_search(name, options.meshes))
            table.add(name, staircase(stairs, 2), nullptr);
    bool missing = false;
    for (const KnownMinima& known : knownMinima()) {
        if (!std::regex_search(known.mesh, options.meshes)) continue;
        const auto bytes = test::sharedFile(std::string("dev/") + known.mesh);
        missing = missing || !bytes;
        if (bytes) table.add(known.mesh, readMesh(*bytes, known.mesh).mesh, &known);
    }
    if (missing) std::puts("real meshes are not here: set QM_SHARED_MESHES");
    return table.finish();
}

} // namespace qm::bench

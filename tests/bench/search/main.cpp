/// \file search-tables [REGEX]: tables of the search's performance; only meshes whose names match.
///
/// Environment: QM_SHARED_MESHES, the folder of real meshes; CBC_SECONDS, GAP_SECONDS and TORUS_SECONDS,
/// limits for slow measurements (60; GAP_SECONDS = 0 leaves out the table of gaps).
#include "bench/search/tables.h"

#include <cstdio>
#include <cstdlib>

namespace {

double seconds(const char* variable) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtod(text, nullptr) : 60;
}

} // namespace

int main(int argc, char** argv) {
    using namespace qm::bench;
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // rows appear as they are measured
    const bool chosen = argc > 1 && *argv[1] != '\0';
    const TableOptions options{std::regex(chosen ? argv[1] : "."), seconds("CBC_SECONDS"),
                               seconds("GAP_SECONDS"), seconds("TORUS_SECONDS")};
    bool good = printOptima(options);
    good = printCounts(options) && good;
    if (!chosen) {
        printListing();
        printTorus(options);
    }
    printGaps(options);
    return good ? 0 : 1;
}

#include "base/at.h"
#include "check/check_sections.h"
#include "check/tracks/paths.h"

namespace qm::check {

namespace {

/// How many edges of a path are on tracks, and how many are not. The mesh boundary bounds patches whether it
/// is demanded or not, and is not counted.
struct EdgeCounts {
    int onTracks = 0;
    int onNone = 0;
};

EdgeCounts countEdges(const Neighbourhoods& around, const std::vector<int>& path,
                      std::span<const char> present) {
    EdgeCounts counts;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const int step = around.stepBetween(path[i - 1], path[i]);
        if (!around.boundary(step)) ++(present[at(around.edge(step))] != 0 ? counts.onTracks : counts.onNone);
    }
    return counts;
}

} // namespace

void checkConstraints(const Context& context, std::span<const char> present, GraphOf what,
                      const std::string& pointer, Report& report) {
    const auto& [required, forbidden, weights] = context.constraints;
    for (std::size_t i = 0; what == GraphOf::mesh && i < required.size(); ++i)
        if (countEdges(context.around, required[i], present).onNone > 0)
            report.violate(pointer, "required",
                           "an edge of " + below("/constraints/required", i) + " is on no track");
    for (std::size_t i = 0; i < forbidden.size(); ++i)
        if (countEdges(context.around, forbidden[i], present).onTracks > 0)
            report.violate(pointer, "forbidden",
                           "an edge of " + below("/constraints/forbidden", i) + " is on a track");
}

bool checkConstraintPaths(const Neighbourhoods& around, const ConstraintsPart& constraints, Report& report) {
    const std::size_t before = report.total();
    const auto read = [&](const std::vector<int>& path, const char* list, std::size_t i) {
        (void)readPath(around, path, below("/constraints", list, i, "vertices"), report);
    };
    for (std::size_t i = 0; i < constraints.required.size(); ++i)
        read(constraints.required[i], "required", i);
    for (std::size_t i = 0; i < constraints.forbidden.size(); ++i)
        read(constraints.forbidden[i], "forbidden", i);
    for (std::size_t i = 0; i < constraints.weights.size(); ++i)
        read(constraints.weights[i].vertices, "weights", i);
    return report.total() == before;
}

} // namespace qm::check

#include "cli/tools/repair_text.h"

#include "base/joined.h"

#include <initializer_list>
#include <utility>
#include <vector>

namespace qm {
namespace {

using Count = std::pair<std::size_t, const char*>;

std::string listOf(std::initializer_list<Count> counts) {
    std::vector<std::string> texts;
    for (const auto& [count, what] : counts)
        if (count > 0) texts.push_back(std::to_string(count) + " " + what);
    return joined(texts);
}

} // namespace

std::string repairText(const RepairReport& report) {
    return listOf({{report.weldedVertices, "vertices welded"},
                   {report.degenerateFaces, "degenerate faces removed"},
                   {report.duplicateFaces, "duplicate faces removed"},
                   {report.flippedFaces, "faces turned over"},
                   {report.splitVertices, "vertices split"}});
}

std::string repairText(const TriangleRepair& report) {
    return listOf({{report.doubledTriangles, "doubled triangles removed"},
                   {report.turnedTriangles, "triangles turned over"},
                   {report.crowdedEdges, "edges of more than two triangles taken apart"},
                   {report.touchingPoints, "points where the surface touched itself split"}});
}

} // namespace qm

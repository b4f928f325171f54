#include "cli/tools/repair_text.h"

#include "base/joined.h"
#include "base/number_text.h"

#include <initializer_list>
#include <vector>

namespace qm {
namespace {

struct Count {
    std::size_t count;
    const char* one;
    const char* several;
};

std::string listOf(std::initializer_list<Count> counts) {
    std::vector<std::string> texts;
    for (const auto& [count, one, several] : counts)
        if (count > 0) texts.push_back(countText(count, one, several));
    return joined(texts);
}

} // namespace

std::string repairText(const RepairReport& report) {
    return listOf({{report.weldedVertices, "vertex welded", "vertices welded"},
                   {report.degenerateFaces, "degenerate face removed", "degenerate faces removed"},
                   {report.duplicateFaces, "duplicate face removed", "duplicate faces removed"},
                   {report.flippedFaces, "face turned over", "faces turned over"},
                   {report.splitVertices, "vertex split", "vertices split"}});
}

std::string repairText(const TriangleRepair& report) {
    return listOf({{report.doubledTriangles, "doubled triangle removed", "doubled triangles removed"},
                   {report.turnedTriangles, "triangle turned over", "triangles turned over"},
                   {report.crowdedEdges, "edge of more than two triangles taken apart",
                    "edges of more than two triangles taken apart"},
                   {report.touchingPoints, "point where the surface touched itself split",
                    "points where the surface touched itself split"}});
}

} // namespace qm

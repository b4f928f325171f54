#include "check/tracks/paths.h"

namespace qm::check {

bool knownVertex(const Neighbourhoods& around, int vertex, const std::string& pointer, Report& report) {
    if (vertex >= 0 && vertex < around.vertices()) return true;
    report.violate(pointer, "vertex", "the mesh has no vertex of this number");
    return false;
}

std::optional<std::vector<int>> readPath(const Neighbourhoods& around, const std::vector<int>& vertices,
                                         const std::string& pointer, Report& report) {
    if (vertices.size() < 2) {
        report.violate(pointer, "path", "a path has at least two vertices");
        return std::nullopt;
    }
    std::vector<int> steps;
    steps.reserve(vertices.size() - 1);
    if (!knownVertex(around, vertices[0], below(pointer, 0), report)) return std::nullopt;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
        if (!knownVertex(around, vertices[i], below(pointer, i), report)) return std::nullopt;
        const int step = around.stepBetween(vertices[i - 1], vertices[i]);
        if (step < 0) {
            report.violate(below(pointer, i), "path",
                           "no edge joins vertices " + std::to_string(vertices[i - 1]) + " and " +
                               std::to_string(vertices[i]));
            return std::nullopt;
        }
        steps.push_back(step);
    }
    return steps;
}

std::size_t firstBend(const Neighbourhoods& around, const std::vector<int>& steps) {
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (!around.passable(around.from(steps[i])) || around.straightOn(steps[i - 1]) != steps[i]) return i;
    return steps.size();
}

} // namespace qm::check

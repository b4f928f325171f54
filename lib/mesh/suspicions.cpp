#include "mesh/suspicions.h"

#include "mesh/quad_geometry.h"
#include "mesh/topology.h"

#include <algorithm>
#include <functional>
#include <unordered_set>

namespace qm {
namespace {

/// How many vertices lie where an earlier one does.
std::size_t coincidentVertices(const QuadMesh& mesh) {
    struct Hash {
        std::size_t operator()(const Point& point) const {
            std::size_t value = 0;
            for (const double coordinate : point)
                value = value * 0x9e3779b97f4a7c15ULL + std::hash<double>{}(coordinate);
            return value;
        }
    };
    std::unordered_set<Point, Hash> places(mesh.n_vertices());
    for (const VertexId vertex : mesh.vertices())
        places.insert(mesh.point(vertex));
    return mesh.n_vertices() - places.size();
}

std::string of(std::size_t some, std::size_t all, const std::string& noun) {
    return std::to_string(some) + " of " + std::to_string(all) + " " + noun + " ";
}

} // namespace

std::vector<std::string> suspicions(const QuadMesh& mesh) {
    std::vector<std::string> result;
    if (const std::size_t coincident = coincidentVertices(mesh); coincident > 0)
        result.push_back(of(coincident, mesh.n_vertices(), "vertices") + (coincident == 1 ? "lies" : "lie") +
                         " where another does. If a seam should be closed, use --repair");
    const auto flat = static_cast<std::size_t>(
        std::ranges::count_if(mesh.faces(), [&](FaceId face) { return !hasArea(mesh, face); }));
    if (flat > 0)
        result.push_back(of(flat, mesh.n_faces(), "quads") + (flat == 1 ? "has" : "have") +
                         " no area. Edges there count as flat");
    const Components parts = components(mesh);
    const auto isolated =
        std::ranges::count_if(mesh.vertices(), [&](VertexId vertex) { return mesh.is_isolated(vertex); });
    if (const auto pieces = parts.count - isolated; pieces > 10)
        result.push_back("the mesh has " + std::to_string(pieces) + " components. Should they be joined?");
    if (const std::size_t extraordinary = extraordinaryVertices(mesh).size();
        extraordinary * 10 > mesh.n_vertices())
        result.push_back(of(extraordinary, mesh.n_vertices(), "vertices") +
                         (extraordinary == 1 ? "is" : "are") + " extraordinary. A semi-regular mesh has few");
    return result;
}

} // namespace qm

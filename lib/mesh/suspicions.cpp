#include "mesh/suspicions.h"

#include "mesh/topology.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

std::size_t coincidentVertices(const QuadMesh& mesh) {
    std::vector<std::array<double, 3>> points;
    for (const VertexId vertex : mesh.vertices()) {
        const Point& p = mesh.point(vertex);
        points.push_back({p[0], p[1], p[2]});
    }
    std::ranges::sort(points);
    std::size_t count = 0;
    for (std::size_t k = 1; k < points.size(); ++k)
        if (points[k] == points[k - 1]) ++count;
    return count;
}

/// Twice the area of the two triangles of a quad, on either side of the diagonal from its first vertex.
double doubleArea(const QuadMesh& mesh, FaceId face) {
    std::array<Point, 4> p;
    HalfedgeId halfedge = mesh.halfedge_handle(face);
    for (Point& corner : p) {
        corner = mesh.point(mesh.to_vertex_handle(halfedge));
        halfedge = mesh.next_halfedge_handle(halfedge);
    }
    return ((p[1] - p[0]) % (p[2] - p[0])).norm() + ((p[2] - p[0]) % (p[3] - p[0])).norm();
}

} // namespace

std::vector<std::string> suspicions(const QuadMesh& mesh) {
    std::vector<std::string> result;
    const std::size_t coincident = coincidentVertices(mesh);
    if (coincident > 0)
        result.push_back(std::to_string(coincident) + " of " + std::to_string(mesh.n_vertices()) +
                         " vertices lie where another does. --repair welds them");
    std::size_t flat = 0;
    for (const FaceId face : mesh.faces())
        if (doubleArea(mesh, face) == 0) ++flat;
    if (flat > 0)
        result.push_back(std::to_string(flat) + " of " + std::to_string(mesh.n_faces()) +
                         " quads have no area. Their edges count as flat");
    std::vector<bool> hasFaces(mesh.n_vertices(), false);
    const Components parts = components(mesh);
    for (const VertexId vertex : mesh.vertices())
        if (!mesh.is_isolated(vertex))
            hasFaces[static_cast<std::size_t>(parts.ofVertex[static_cast<std::size_t>(vertex.idx())])] = true;
    const auto pieces = std::ranges::count(hasFaces, true);
    if (pieces > 10)
        result.push_back("the mesh has " + std::to_string(pieces) + " components. Should they be joined?");
    const std::size_t extraordinary = extraordinaryVertices(mesh).size();
    if (extraordinary * 10 > mesh.n_vertices())
        result.push_back(std::to_string(extraordinary) + " of " + std::to_string(mesh.n_vertices()) +
                         " vertices are extraordinary. A semi-regular mesh has few");
    return result;
}

} // namespace qm

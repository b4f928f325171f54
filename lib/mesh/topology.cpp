#include "mesh/topology.h"

#include <algorithm>

namespace qm {

bool isRegular(const QuadMesh& mesh, VertexId vertex) {
    if (mesh.is_isolated(vertex)) return true;
    const unsigned edges = mesh.valence(vertex);
    return mesh.is_boundary(vertex) ? edges <= 3 : edges == 4;
}

std::vector<VertexId> extraordinaryVertices(const QuadMesh& mesh) {
    std::vector<VertexId> result;
    for (const VertexId vertex : mesh.vertices())
        if (!isRegular(mesh, vertex)) result.push_back(vertex);
    return result;
}

std::vector<VertexId> verticesAlong(const QuadMesh& mesh, const std::vector<HalfedgeId>& halfedges) {
    std::vector<VertexId> vertices;
    if (halfedges.empty()) return vertices;
    vertices.reserve(halfedges.size() + 1);
    vertices.push_back(mesh.from_vertex_handle(halfedges.front()));
    for (const HalfedgeId halfedge : halfedges)
        vertices.push_back(mesh.to_vertex_handle(halfedge));
    return vertices;
}

std::optional<std::vector<HalfedgeId>> halfedgesAlong(const QuadMesh& mesh,
                                                      const std::vector<VertexId>& vertices) {
    std::vector<HalfedgeId> halfedges;
    for (std::size_t k = 1; k < vertices.size(); ++k) {
        const HalfedgeId halfedge = mesh.find_halfedge(vertices[k - 1], vertices[k]);
        if (!halfedge.is_valid()) return std::nullopt;
        halfedges.push_back(halfedge);
    }
    return halfedges;
}

Components components(const QuadMesh& mesh) {
    Components result;
    result.ofVertex.assign(mesh.n_vertices(), -1);
    std::vector<VertexId> pending;
    const auto visit = [&](VertexId vertex) {
        int& component = result.ofVertex[static_cast<std::size_t>(vertex.idx())];
        if (component >= 0) return;
        component = result.count;
        pending.push_back(vertex);
    };
    for (const VertexId start : mesh.vertices()) {
        if (result.ofVertex[static_cast<std::size_t>(start.idx())] >= 0) continue;
        visit(start);
        while (!pending.empty()) {
            const VertexId vertex = pending.back();
            pending.pop_back();
            for (const VertexId neighbour : mesh.vv_range(vertex))
                visit(neighbour);
        }
        ++result.count;
    }
    return result;
}

} // namespace qm

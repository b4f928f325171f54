#include "mesh/mesh_lines.h"

#include "base/at.h"
#include "mesh/topology.h"

namespace qm {

MeshLine straightFrom(const QuadMesh& mesh, HalfedgeId start) {
    MeshLine line{{start}, false};
    while (!line.closed && continuesStraight(mesh, mesh.to_vertex_handle(line.halfedges.back()))) {
        const HalfedgeId next = straightOn(mesh, line.halfedges.back());
        line.closed = next == start;
        if (!line.closed) line.halfedges.push_back(next);
    }
    return line;
}

void forEachMeshLine(const QuadMesh& mesh, const std::function<void(const MeshLine&)>& visit) {
    std::vector<bool> isVisited(mesh.n_edges(), false);
    const auto visitFrom = [&](HalfedgeId start) {
        const EdgeId first = mesh.edge_handle(start);
        if (isVisited[at(first)] || mesh.is_boundary(first)) return;
        const MeshLine line = straightFrom(mesh, start);
        for (const HalfedgeId halfedge : line.halfedges)
            isVisited[at(mesh.edge_handle(halfedge))] = true;
        visit(line);
    };
    for (const VertexId vertex : mesh.vertices())
        if (!mesh.is_isolated(vertex) && !continuesStraight(mesh, vertex))
            for (const HalfedgeId start : mesh.voh_range(vertex))
                visitFrom(start);
    for (const EdgeId edge : mesh.edges())
        visitFrom(mesh.halfedge_handle(edge, 0));
}

} // namespace qm

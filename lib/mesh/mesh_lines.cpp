#include "mesh/mesh_lines.h"

#include "base/at.h"
#include "mesh/topology.h"

namespace qm {
namespace {

class Tracer {
public:
    explicit Tracer(const QuadMesh& mesh) : mesh_(mesh), visited_(mesh.n_edges(), false) {}

    [[nodiscard]] bool fresh(HalfedgeId halfedge) const {
        return !visited_[index(halfedge)] && !mesh_.is_boundary(mesh_.edge_handle(halfedge));
    }

    MeshLine trace(HalfedgeId start) {
        MeshLine line = straightFrom(mesh_, start);
        for (const HalfedgeId halfedge : line.halfedges)
            visited_[index(halfedge)] = true;
        return line;
    }

private:
    [[nodiscard]] std::size_t index(HalfedgeId halfedge) const { return at(mesh_.edge_handle(halfedge)); }

    const QuadMesh& mesh_;
    std::vector<bool> visited_;
};

} // namespace

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
    Tracer tracer(mesh);
    for (const VertexId vertex : mesh.vertices()) {
        if (mesh.is_isolated(vertex) || continuesStraight(mesh, vertex)) continue;
        for (const HalfedgeId start : mesh.voh_range(vertex))
            if (tracer.fresh(start)) visit(tracer.trace(start));
    }
    for (const EdgeId edge : mesh.edges())
        if (tracer.fresh(mesh.halfedge_handle(edge, 0))) visit(tracer.trace(mesh.halfedge_handle(edge, 0)));
}

} // namespace qm

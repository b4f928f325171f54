#include "layout/corners.h"

#include "mesh/topology.h"

#include <set>
#include <unordered_set>

namespace qm {
namespace {

std::size_t facesAround(const QuadMesh& mesh, VertexId vertex) {
    std::size_t faces = 0;
    for (const FaceId face : mesh.vf_range(vertex))
        faces += face.is_valid() ? 1 : 0;
    return faces;
}

} // namespace

Corners::Corners(const QuadMesh& mesh, const SubMeshes& subMeshes)
    : mesh_(mesh), subMeshes_(subMeshes), fixed_(at(subMeshes.count), 0) {
    for (const VertexId vertex : mesh.vertices()) {
        const bool regular = isRegular(mesh, vertex);
        if (regular && !mesh.is_boundary(vertex)) continue;
        const std::size_t faces = facesAround(mesh, vertex);
        if (!regular || faces == 1) fixed_[subMeshes.of(vertex)] += faces;
    }
}

std::size_t Corners::between(const std::vector<Track>& tracks, SubMeshId subMesh) const {
    std::unordered_set<int> edges;
    std::set<VertexId> vertices;
    for (const Track& track : tracks)
        for (const HalfedgeId halfedge : track.halfedges) {
            edges.insert(mesh_.edge_handle(halfedge).idx());
            vertices.insert({mesh_.from_vertex_handle(halfedge), mesh_.to_vertex_handle(halfedge)});
        }
    const auto onTrack = [&](HalfedgeId halfedge) {
        return edges.contains(mesh_.edge_handle(halfedge).idx());
    };
    std::size_t corners = fixed(subMesh);
    for (const VertexId vertex : vertices) {
        if (!isRegular(mesh_, vertex)) continue;
        if (mesh_.is_boundary(vertex))
            corners += 2;
        else if (subMeshes_.of(vertex) == subMesh)
            for (const HalfedgeId halfedge : mesh_.vih_range(vertex))
                corners += onTrack(halfedge) && onTrack(mesh_.next_halfedge_handle(halfedge)) ? 1 : 0;
    }
    return corners;
}

} // namespace qm

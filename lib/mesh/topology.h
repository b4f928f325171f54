/// \file Regular vertices, and walking straight on (docs/METHOD.md#words).
#pragma once

#include "mesh/quad_mesh.h"

#include <array>
#include <span>
#include <vector>

namespace qm {

/// Whether a vertex is interior with four edges, or on the boundary with one or two faces. Isolated vertices
/// count as regular, because no line reaches them.
[[nodiscard]] bool isRegular(const QuadMesh& mesh, VertexId vertex);

/// All vertices that are not regular, ascending.
[[nodiscard]] std::vector<VertexId> extraordinaryVertices(const QuadMesh& mesh);

/// From where a halfedge leads, and to where; of an edge, its first halfedge.
[[nodiscard]] inline std::array<VertexId, 2> endsOf(const QuadMesh& mesh, HalfedgeId halfedge) {
    return {mesh.from_vertex_handle(halfedge), mesh.to_vertex_handle(halfedge)};
}
[[nodiscard]] inline std::array<VertexId, 2> endsOf(const QuadMesh& mesh, EdgeId edge) {
    return endsOf(mesh, mesh.halfedge_handle(edge, 0));
}

/// The faces on both sides of an edge; beyond the boundary an invalid one.
[[nodiscard]] inline std::array<FaceId, 2> facesBeside(const QuadMesh& mesh, EdgeId edge) {
    return {mesh.face_handle(mesh.halfedge_handle(edge, 0)), mesh.face_handle(mesh.halfedge_handle(edge, 1))};
}

/// The halfedge that continues `halfedge` straight across its end, which must be an interior regular vertex.
[[nodiscard]] inline HalfedgeId straightOn(const QuadMesh& mesh, HalfedgeId halfedge) {
    return mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(halfedge)));
}

/// Whether `straightOn` applies at a vertex: it is interior and regular.
[[nodiscard]] inline bool continuesStraight(const QuadMesh& mesh, VertexId vertex) {
    return !mesh.is_boundary(vertex) && isRegular(mesh, vertex);
}

/// All halfedges that leave a vertex, counter-clockwise from a first one.
[[nodiscard]] std::vector<HalfedgeId> leavingFrom(const QuadMesh& mesh, HalfedgeId first);

/// The opposite side of the quad on the left of a halfedge, in the same direction: the next quad is on its
/// left.
[[nodiscard]] inline HalfedgeId acrossQuad(const QuadMesh& mesh, HalfedgeId halfedge) {
    return mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(mesh.next_halfedge_handle(halfedge)));
}

/// The vertices along consecutive halfedges, one more than there are halfedges; empty if there are none.
[[nodiscard]] std::vector<VertexId> verticesAlong(const QuadMesh& mesh,
                                                  std::span<const HalfedgeId> halfedges);

/// The sum of a value of every edge along consecutive halfedges.
[[nodiscard]] double sumAlong(const QuadMesh& mesh, std::span<const HalfedgeId> path,
                              const std::vector<double>& perEdge);

/// The connected component of every vertex; components are numbered from 0 in the order of their lowest
/// vertices. Isolated vertices are components of their own.
struct Components {
    std::vector<int> ofVertex;
    int count = 0;
};
[[nodiscard]] Components components(const QuadMesh& mesh);

/// The number of components that have faces.
[[nodiscard]] std::size_t pieceCount(const QuadMesh& mesh);

} // namespace qm

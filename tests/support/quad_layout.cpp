#include "support/quad_layout.h"

namespace qm::test {

Layout segmentPerQuad(const QuadMesh& mesh) {
    Layout layout;
    for (const FaceId face : mesh.faces()) {
        Segment segment;
        segment.size = {1, 1};
        segment.faces = {face};
        HalfedgeId halfedge = mesh.halfedge_handle(face);
        for (std::size_t k = 0; k < 4; ++k, halfedge = mesh.next_halfedge_handle(halfedge)) {
            segment.corners[k] = mesh.from_vertex_handle(halfedge);
            segment.sides[k] = {mesh.from_vertex_handle(halfedge), mesh.to_vertex_handle(halfedge)};
        }
        layout.segments.push_back(std::move(segment));
    }
    return layout;
}

} // namespace qm::test

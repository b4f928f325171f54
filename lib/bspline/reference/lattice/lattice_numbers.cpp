#include "bspline/reference/lattice/lattice_numbers.h"

#include "base/at.h"

#include <utility>

namespace qm {

std::size_t LatticeNumbers::count() const {
    const std::size_t inside = at(squares_ - 1);
    return mesh_->n_vertices() + mesh_->n_edges() * inside + mesh_->n_faces() * inside * inside;
}

std::size_t LatticeNumbers::onEdge(HalfedgeId halfedge, int along) const {
    if (along == 0) return at(mesh_->from_vertex_handle(halfedge));
    if (along == squares_) return at(mesh_->to_vertex_handle(halfedge));
    const EdgeId edge = mesh_->edge_handle(halfedge);
    const int place = halfedge == mesh_->halfedge_handle(edge, 0) ? along : squares_ - along;
    return mesh_->n_vertices() + at(edge) * at(squares_ - 1) + at(place - 1);
}

std::size_t LatticeNumbers::operator()(HalfedgeId halfedge, int along, int depth) const {
    if (depth == 0) return onEdge(halfedge, along);
    if (along == squares_) return onEdge(mesh_->next_halfedge_handle(halfedge), depth);
    const HalfedgeId previous = mesh_->prev_halfedge_handle(halfedge);
    if (along == 0) return onEdge(previous, squares_ - depth);
    if (depth == squares_) return onEdge(mesh_->prev_halfedge_handle(previous), squares_ - along);
    const FaceId face = mesh_->face_handle(halfedge);
    const HalfedgeId first = mesh_->halfedge_handle(face);
    for (HalfedgeId h = halfedge; h != first; h = mesh_->prev_halfedge_handle(h))
        along = std::exchange(depth, along), along = squares_ - along;
    return mesh_->n_vertices() + mesh_->n_edges() * at(squares_ - 1) +
           (at(face) * at(squares_ - 1) + at(depth - 1)) * at(squares_ - 1) + at(along - 1);
}

std::array<VertexId, 4> LatticeNumbers::corners(FaceId face) const {
    std::array<VertexId, 4> result;
    HalfedgeId side = mesh_->halfedge_handle(face);
    for (VertexId& vertex : result) {
        vertex = mesh_->from_vertex_handle(side);
        side = mesh_->next_halfedge_handle(side);
    }
    return result;
}

std::vector<std::size_t> LatticeNumbers::ofSegment(const Segment& segment) const {
    const auto [columns, rows] = segment.size;
    const std::size_t width = at(columns * squares_ + 1);
    std::vector<std::size_t> numbers(width * at(rows * squares_ + 1));
    const std::vector<VertexId> vertices = vertexGrid(*mesh_, segment);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            HalfedgeId halfedge = mesh_->halfedge_handle(segment.faces[at(j * columns + i)]);
            while (mesh_->from_vertex_handle(halfedge) != vertices[at(j * (columns + 1) + i)])
                halfedge = mesh_->next_halfedge_handle(halfedge);
            std::size_t* corner = numbers.data() + at(j * squares_) * width + at(i * squares_);
            for (int depth = 0; depth <= squares_; ++depth)
                for (int along = 0; along <= squares_; ++along)
                    corner[at(depth) * width + at(along)] = (*this)(halfedge, along, depth);
        }
    return numbers;
}

} // namespace qm

#include "bspline/reference/lattice_numbers.h"

#include <utility>

namespace qm {
namespace {

std::size_t size(int number) {
    return static_cast<std::size_t>(number);
}

} // namespace

std::size_t LatticeNumbers::count() const {
    const std::size_t inside = size(squares_ - 1);
    return mesh_->n_vertices() + mesh_->n_edges() * inside + mesh_->n_faces() * inside * inside;
}

std::size_t LatticeNumbers::onEdge(HalfedgeId halfedge, int along) const {
    if (along == 0) return size(mesh_->from_vertex_handle(halfedge).idx());
    if (along == squares_) return size(mesh_->to_vertex_handle(halfedge).idx());
    const EdgeId edge = mesh_->edge_handle(halfedge);
    const int place = halfedge == mesh_->halfedge_handle(edge, 0) ? along : squares_ - along;
    return mesh_->n_vertices() + size(edge.idx()) * size(squares_ - 1) + size(place - 1);
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
    return mesh_->n_vertices() + mesh_->n_edges() * size(squares_ - 1) +
           (size(face.idx()) * size(squares_ - 1) + size(depth - 1)) * size(squares_ - 1) + size(along - 1);
}

std::vector<std::size_t> LatticeNumbers::ofSegment(const Segment& segment) const {
    const auto [columns, rows] = segment.size;
    const std::size_t width = size(columns * squares_ + 1);
    std::vector<std::size_t> numbers(width * size(rows * squares_ + 1));
    const std::vector<VertexId> vertices = vertexGrid(*mesh_, segment);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            HalfedgeId halfedge = mesh_->halfedge_handle(segment.faces[size(j * columns + i)]);
            while (mesh_->from_vertex_handle(halfedge) != vertices[size(j * (columns + 1) + i)])
                halfedge = mesh_->next_halfedge_handle(halfedge);
            std::size_t* corner = numbers.data() + size(j * squares_) * width + size(i * squares_);
            for (int depth = 0; depth <= squares_; ++depth)
                for (int along = 0; along <= squares_; ++along)
                    corner[size(depth) * width + size(along)] = (*this)(halfedge, along, depth);
        }
    return numbers;
}

} // namespace qm

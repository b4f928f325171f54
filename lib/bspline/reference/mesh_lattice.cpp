#include "bspline/reference/mesh_lattice.h"

#include "base/parallel.h"
#include "bspline/reference/vertex_stencil.h"

#include <algorithm>
#include <span>
#include <utility>

namespace qm {
namespace {

std::size_t size(int number) {
    return static_cast<std::size_t>(number);
}

/// Calls f(0) ... f(count - 1), many in a row on one thread.
template <class Function> void inBlocks(std::size_t count, unsigned jobs, const Function& f) {
    constexpr std::size_t block = 2048;
    parallelFor((count + block - 1) / block, jobs, [&](std::size_t number) {
        for (std::size_t k = number * block; k < std::min(count, (number + 1) * block); ++k)
            f(k);
    });
}

} // namespace

/// Away from the mesh's own vertices all is tensor product: cubic splines are subdivided, or evaluated at
/// their knots, one direction after the other.
struct MeshLattice::Step {
    bool subdivides = true;
    double neighbour = 1.0 / 8; ///< weight of each of two neighbours
    void (*vertexStencil)(const QuadMesh&, VertexId, const VertexRule&, VertexStencil&) = subdivisionStencil;

    [[nodiscard]] Eigen::Vector3d smooth(const Eigen::Vector3d& before, const Eigen::Vector3d& at,
                                         const Eigen::Vector3d& after) const {
        return (1 - 2 * neighbour) * at + neighbour * (before + after);
    }
    /// What lies between the ends of a line of points.
    /// \param write  gets the place in the new line and the point
    template <class Write>
    void line(int squares, std::span<const Eigen::Vector3d> points, std::size_t stride,
              const Write& write) const {
        const auto point = [&](int k) -> const Eigen::Vector3d& { return points[size(k) * stride]; };
        const int factor = subdivides ? 2 : 1;
        for (int k = 1; k < squares; ++k)
            write(factor * k, smooth(point(k - 1), point(k), point(k + 1)));
        if (subdivides)
            for (int k = 0; k < squares; ++k)
                write(2 * k + 1, 0.5 * (point(k) + point(k + 1)));
    }
};

MeshLattice::MeshLattice(const QuadMesh& mesh, const std::vector<Point>& points) : mesh_(&mesh) {
    points_.reserve(points.size());
    for (const Point& point : points)
        points_.push_back(vector(point));
}

MeshLattice::MeshLattice(const QuadMesh& mesh, int squares)
    : mesh_(&mesh), squares_(squares), points_(mesh.n_vertices() + mesh.n_edges() * (size(squares) - 1) +
                                                   mesh.n_faces() * (size(squares) - 1) * (size(squares) - 1),
                                               Eigen::Vector3d::Zero()) {}

std::size_t MeshLattice::numberOnEdge(HalfedgeId halfedge, int along) const {
    if (along == 0) return size(mesh_->from_vertex_handle(halfedge).idx());
    if (along == squares_) return size(mesh_->to_vertex_handle(halfedge).idx());
    const EdgeId edge = mesh_->edge_handle(halfedge);
    const int place = halfedge == mesh_->halfedge_handle(edge, 0) ? along : squares_ - along;
    return mesh_->n_vertices() + size(edge.idx()) * size(squares_ - 1) + size(place - 1);
}

std::size_t MeshLattice::number(HalfedgeId halfedge, int along, int depth) const {
    if (depth == 0) return numberOnEdge(halfedge, along);
    if (along == squares_) return numberOnEdge(mesh_->next_halfedge_handle(halfedge), depth);
    const HalfedgeId previous = mesh_->prev_halfedge_handle(halfedge);
    if (along == 0) return numberOnEdge(previous, squares_ - depth);
    if (depth == squares_) return numberOnEdge(mesh_->prev_halfedge_handle(previous), squares_ - along);
    const FaceId face = mesh_->face_handle(halfedge);
    const HalfedgeId first = mesh_->halfedge_handle(face);
    for (HalfedgeId h = halfedge; h != first; h = mesh_->prev_halfedge_handle(h))
        along = std::exchange(depth, along), along = squares_ - along;
    return mesh_->n_vertices() + mesh_->n_edges() * size(squares_ - 1) +
           (size(face.idx()) * size(squares_ - 1) + size(depth - 1)) * size(squares_ - 1) + size(along - 1);
}

MeshLattice MeshLattice::subdivided(const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
                                    unsigned jobs) const {
    return filtered({true, 1.0 / 8, subdivisionStencil}, rules, sharp, jobs);
}

MeshLattice MeshLattice::limit(const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
                               unsigned jobs) const {
    return filtered({false, 1.0 / 6, limitStencil}, rules, sharp, jobs);
}

MeshLattice MeshLattice::filtered(const Step& step, const std::vector<VertexRule>& rules,
                                  const std::vector<bool>& sharp, unsigned jobs) const {
    MeshLattice to(*mesh_, step.subdivides ? 2 * squares_ : squares_);
    inBlocks(mesh_->n_vertices(), jobs,
             [&](std::size_t k) { filterVertex(step, VertexId(static_cast<int>(k)), rules[k], to); });
    inBlocks(mesh_->n_edges(), jobs,
             [&](std::size_t k) { filterEdge(step, EdgeId(static_cast<int>(k)), sharp[k], to); });
    inBlocks(mesh_->n_faces(), jobs,
             [&](std::size_t k) { filterFace(step, FaceId(static_cast<int>(k)), to); });
    return to;
}

void MeshLattice::filterVertex(const Step& step, VertexId vertex, const VertexRule& rule,
                               MeshLattice& to) const {
    thread_local VertexStencil stencil;
    step.vertexStencil(*mesh_, vertex, rule, stencil);
    Eigen::Vector3d sum = stencil.own * points_[size(vertex.idx())];
    for (const VertexStencil::Term& term : stencil.around)
        sum += term.weight * points_[number(term.halfedge, 1, term.diagonal ? 1 : 0)];
    to.points_[size(vertex.idx())] = sum;
}

void MeshLattice::filterEdge(const Step& step, EdgeId edge, bool sharp, MeshLattice& to) const {
    const HalfedgeId halfedge = mesh_->halfedge_handle(edge, 0);
    const HalfedgeId opposite = mesh_->halfedge_handle(edge, 1);
    thread_local std::vector<Eigen::Vector3d> line;
    line.clear();
    for (int k = 0; k <= squares_; ++k) {
        const Eigen::Vector3d& point = points_[numberOnEdge(halfedge, k)];
        line.push_back(sharp ? point
                             : step.smooth(points_[number(halfedge, k, 1)], point,
                                           points_[number(opposite, squares_ - k, 1)]));
    }
    step.line(squares_, line, 1,
              [&](int k, const Eigen::Vector3d& point) { to.points_[to.numberOnEdge(halfedge, k)] = point; });
}

void MeshLattice::filterFace(const Step& step, FaceId face, MeshLattice& to) const {
    const HalfedgeId first = mesh_->halfedge_handle(face);
    thread_local std::vector<Eigen::Vector3d> rows;
    thread_local std::vector<Eigen::Vector3d> half; // filtered along the rows, not yet across
    const std::size_t width = size(squares_) + 1;
    const std::size_t newWidth = size(to.squares_) + 1;
    rows.clear();
    for (int j = 0; j <= squares_; ++j)
        for (int i = 0; i <= squares_; ++i)
            rows.push_back(points_[number(first, i, j)]);
    half.assign(width * newWidth, Eigen::Vector3d::Zero());
    for (std::size_t j = 0; j < width; ++j)
        step.line(squares_, std::span(rows).subspan(j * width), 1,
                  [&](int i, const Eigen::Vector3d& point) { half[j * newWidth + size(i)] = point; });
    for (int i = 1; i < to.squares_; ++i)
        step.line(squares_, std::span(half).subspan(size(i)), newWidth,
                  [&](int j, const Eigen::Vector3d& point) { to.points_[to.number(first, i, j)] = point; });
}

} // namespace qm

#include "bspline/reference/lattice/mesh_lattice.h"

#include "base/at.h"
#include "bspline/reference/lattice/lagrange.h"
#include "bspline/reference/lattice/vertex_stencil.h"
#include "mesh/parallel_elements.h"

#include <span>

namespace qm {

/// Away from the mesh's own vertices all is tensor product: cubic splines are subdivided, or evaluated at
/// their knots, one direction after the other.
struct MeshLattice::Step {
    bool subdivides;
    double neighbour; ///< weight of each of two neighbours
    VertexStencil (*vertexStencil)(const QuadMesh&, VertexId, const VertexRule&);

    [[nodiscard]] Eigen::Vector3d smooth(const Eigen::Vector3d& before, const Eigen::Vector3d& at,
                                         const Eigen::Vector3d& after) const {
        return (1 - 2 * neighbour) * at + neighbour * (before + after);
    }
    /// What lies between the ends of a line of points.
    /// \param write  gets the place in the new line and the point
    template <class Write>
    void line(int squares, std::span<const Eigen::Vector3d> points, std::size_t stride,
              const Write& write) const {
        const auto point = [&](int k) -> const Eigen::Vector3d& { return points[at(k) * stride]; };
        const int factor = subdivides ? 2 : 1;
        for (int k = 1; k < squares; ++k)
            write(factor * k, smooth(point(k - 1), point(k), point(k + 1)));
        if (subdivides)
            for (int k = 0; k < squares; ++k)
                write(2 * k + 1, 0.5 * (point(k) + point(k + 1)));
    }
};

MeshLattice::MeshLattice(const QuadMesh& mesh, const std::vector<Point>& points) : numbers_(mesh, 1) {
    points_.reserve(points.size());
    for (const Point& point : points)
        points_.push_back(vector(point));
}

MeshLattice::MeshLattice(const LatticeNumbers& numbers) : numbers_(numbers), points_(numbers.count()) {}

Point MeshLattice::derivative(HalfedgeId leaving) const {
    return qm::point(derivativeAtEnd(
        squares(), 0, [&](int k) -> const Eigen::Vector3d& { return points_[numbers_(leaving, k, 0)]; }));
}

std::vector<Eigen::Vector3d> MeshLattice::points(FaceId face) const {
    std::vector<Eigen::Vector3d> result;
    result.reserve(at(squares() + 1) * at(squares() + 1));
    for (int j = 0; j <= squares(); ++j)
        for (int i = 0; i <= squares(); ++i)
            result.push_back(points_[numbers_(face, i, j)]);
    return result;
}

MeshLattice MeshLattice::subdivided(const Sharpness& sharpness, unsigned jobs) const {
    return filtered({true, 1.0 / 8, subdivisionStencil}, sharpness, jobs);
}

MeshLattice MeshLattice::limit(const Sharpness& sharpness, unsigned jobs) const {
    return filtered({false, 1.0 / 6, limitStencil}, sharpness, jobs);
}

MeshLattice MeshLattice::filtered(const Step& step, const Sharpness& sharpness, unsigned jobs) const {
    const QuadMesh& mesh = numbers_.mesh();
    MeshLattice to(LatticeNumbers(mesh, step.subdivides ? 2 * squares() : squares()));
    parallelForVertices(
        mesh, jobs, [&](VertexId vertex) { filterVertex(step, vertex, sharpness.rules[at(vertex)], to); });
    parallelForEdges(mesh, jobs, [&](EdgeId edge) { filterEdge(step, edge, sharpness.edges[at(edge)], to); });
    parallelForFaces(mesh, jobs, [&](FaceId face) { filterFace(step, face, to); });
    return to;
}

void MeshLattice::filterVertex(const Step& step, VertexId vertex, const VertexRule& rule,
                               MeshLattice& to) const {
    const VertexStencil stencil = step.vertexStencil(numbers_.mesh(), vertex, rule);
    Eigen::Vector3d sum = stencil.own * points_[at(vertex)];
    for (const VertexStencil::Term& term : stencil.around)
        sum += term.weight * points_[numbers_(term.halfedge, 1, term.diagonal ? 1 : 0)];
    to.points_[at(vertex)] = sum;
}

void MeshLattice::filterEdge(const Step& step, EdgeId edge, bool sharp, MeshLattice& to) const {
    const HalfedgeId halfedge = numbers_.mesh().halfedge_handle(edge, 0);
    const HalfedgeId opposite = numbers_.mesh().halfedge_handle(edge, 1);
    std::vector<Eigen::Vector3d> line;
    line.reserve(at(squares()) + 1);
    for (int k = 0; k <= squares(); ++k) {
        const Eigen::Vector3d& point = points_[numbers_(halfedge, k, 0)];
        line.push_back(sharp ? point
                             : step.smooth(points_[numbers_(halfedge, k, 1)], point,
                                           points_[numbers_(opposite, squares() - k, 1)]));
    }
    step.line(squares(), line, 1,
              [&](int k, const Eigen::Vector3d& point) { to.points_[to.numbers_(halfedge, k, 0)] = point; });
}

void MeshLattice::filterFace(const Step& step, FaceId face, MeshLattice& to) const {
    const std::vector<Eigen::Vector3d> rows = points(face);
    const std::size_t width = at(squares()) + 1;
    const std::size_t newWidth = at(to.squares()) + 1;
    // Filtered along the rows, not yet across.
    std::vector<Eigen::Vector3d> half(width * newWidth, Eigen::Vector3d::Zero());
    for (std::size_t j = 0; j < width; ++j)
        step.line(squares(), std::span(rows).subspan(j * width), 1,
                  [&](int i, const Eigen::Vector3d& point) { half[j * newWidth + at(i)] = point; });
    for (int i = 1; i < to.squares(); ++i)
        step.line(squares(), std::span(half).subspan(at(i)), newWidth,
                  [&](int j, const Eigen::Vector3d& point) { to.points_[to.numbers_(face, i, j)] = point; });
}

} // namespace qm

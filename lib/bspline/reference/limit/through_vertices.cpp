#include "bspline/reference/limit/through_vertices.h"

#include "base/at.h"
#include "bspline/reference/lattice/hermite.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

class VertexDistances {
public:
    VertexDistances(MeshLattice& lattice, const std::vector<bool>& interpolates)
        : lattice_(lattice), mesh_(lattice.numbers().mesh()), missing_(mesh_.n_vertices(), Point(0, 0, 0)),
          hermite_(hermiteByStep(lattice.squares())) {
        for (const VertexId vertex : mesh_.vertices())
            if (!interpolates[at(vertex)])
                missing_[at(vertex)] = mesh_.point(vertex) - lattice.point(at(vertex));
    }

    void moveEdge(EdgeId edge) {
        const HalfedgeId side = mesh_.halfedge_handle(edge, 0);
        const Point& begin = missing_[at(mesh_.from_vertex_handle(side))];
        const Point& end = missing_[at(mesh_.to_vertex_handle(side))];
        lattice_.moveEdge(side, [&](int k) {
            const auto& value = hermite_[at(k)].value;
            return lattice_.point(side, k, 0) + (value[0][0] * begin + value[1][0] * end);
        });
    }

    void moveFace(FaceId face) {
        std::array<Point, 4> missing;
        std::ranges::transform(lattice_.numbers().corners(face), missing.begin(),
                               [&](VertexId vertex) { return missing_[at(vertex)]; });
        lattice_.moveInside(face, [&](int i, int j) {
            return lattice_.point(face, i, j) + betweenCorners(hermite_[at(i)], hermite_[at(j)], missing);
        });
    }

private:
    MeshLattice& lattice_;
    const QuadMesh& mesh_;
    std::vector<Point> missing_;   ///< by vertex
    std::vector<Hermite> hermite_; ///< by step along an edge
};

} // namespace

void drawThroughVertices(MeshLattice& lattice, const std::vector<bool>& interpolates, unsigned jobs) {
    const QuadMesh& mesh = lattice.numbers().mesh();
    VertexDistances distances(lattice, interpolates);
    const auto follows = [&](auto&& vertices) {
        return std::ranges::any_of(vertices, [&](VertexId vertex) { return !interpolates[at(vertex)]; });
    };
    parallelForEdges(mesh, jobs, [&](EdgeId edge) {
        if (follows(endsOf(mesh, edge))) distances.moveEdge(edge);
    });
    parallelForFaces(mesh, jobs, [&](FaceId face) {
        if (follows(mesh.fv_range(face))) distances.moveFace(face);
    });
    for (const VertexId vertex : mesh.vertices())
        lattice.move(vertex, mesh.point(vertex));
}

} // namespace qm

#include "bspline/reference/limit/through_vertices.h"

#include "base/at.h"
#include "bspline/reference/lattice/hermite.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>
#include <cstddef>

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
        for (int i = 1; i < lattice_.squares(); ++i) {
            const auto& value = hermite_[at(i)].value;
            add(lattice_.numbers()(side, i, 0), value[0][0] * begin + value[1][0] * end);
        }
    }

    void moveFace(FaceId face) {
        std::array<Point, 4> missing;
        std::ranges::transform(lattice_.numbers().corners(face), missing.begin(),
                               [&](VertexId vertex) { return missing_[at(vertex)]; });
        for (int j = 1; j < lattice_.squares(); ++j)
            for (int i = 1; i < lattice_.squares(); ++i)
                add(lattice_.numbers()(face, i, j),
                    betweenCorners(hermite_[at(i)], hermite_[at(j)], missing));
    }

private:
    void add(std::size_t number, const Point& distance) {
        lattice_.move(number, lattice_.point(number) + distance);
    }

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

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
        : lattice_(lattice), mesh_(lattice.numbers().mesh()), missing_(mesh_.n_vertices(), Point(0, 0, 0)) {
        for (const VertexId vertex : mesh_.vertices())
            if (!interpolates[at(vertex)])
                missing_[at(vertex)] = mesh_.point(vertex) - lattice.point(at(vertex));
        for (const Hermite& hermite : hermiteByStep(lattice.squares()))
            shares_.push_back({hermite.value[0][0], hermite.value[1][0]});
    }

    void moveEdge(EdgeId edge) {
        const HalfedgeId side = mesh_.halfedge_handle(edge, 0);
        const Point begin = missingAt(mesh_.from_vertex_handle(side));
        const Point end = missingAt(mesh_.to_vertex_handle(side));
        for (int i = 1; i < lattice_.squares(); ++i)
            add(lattice_.numbers()(side, i, 0), shares_[at(i)][0] * begin + shares_[at(i)][1] * end);
    }

    void moveFace(FaceId face) {
        const HalfedgeId side = mesh_.halfedge_handle(face);
        const HalfedgeId far = mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(side));
        const std::array near{missingAt(mesh_.from_vertex_handle(side)),
                              missingAt(mesh_.to_vertex_handle(side))};
        const std::array beyond{missingAt(mesh_.to_vertex_handle(far)),
                                missingAt(mesh_.from_vertex_handle(far))};
        for (int j = 1; j < lattice_.squares(); ++j)
            for (int i = 1; i < lattice_.squares(); ++i) {
                const auto& [first, second] = shares_[at(i)];
                add(lattice_.numbers()(side, i, j),
                    shares_[at(j)][0] * (first * near[0] + second * near[1]) +
                        shares_[at(j)][1] * (first * beyond[0] + second * beyond[1]));
            }
    }

private:
    [[nodiscard]] const Point& missingAt(VertexId vertex) const { return missing_[at(vertex)]; }
    void add(std::size_t number, const Point& distance) {
        lattice_.move(number, lattice_.point(number) + distance);
    }

    MeshLattice& lattice_;
    const QuadMesh& mesh_;
    std::vector<Point> missing_;                ///< by vertex
    std::vector<std::array<double, 2>> shares_; ///< by step along an edge: of what its two ends miss
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

#include "bspline/reference/limit/through_vertices.h"

#include "base/at.h"
#include "bspline/reference/lattice/hermite.h"
#include "mesh/parallel_elements.h"
#include "mesh/topology.h"

#include <algorithm>
#include <array>

namespace qm {

void drawThroughVertices(MeshLattice& lattice, const std::vector<bool>& interpolates, unsigned jobs) {
    const QuadMesh& mesh = lattice.numbers().mesh();
    const std::vector<Hermite> hermite = hermiteByStep(lattice.squares());
    std::vector<Point> missing(mesh.n_vertices(), Point(0, 0, 0));
    for (const VertexId vertex : mesh.vertices())
        if (!interpolates[at(vertex)]) missing[at(vertex)] = mesh.point(vertex) - lattice.point(at(vertex));
    const auto follows = [&](const auto& vertices) {
        return std::ranges::any_of(vertices, [&](VertexId vertex) { return !interpolates[at(vertex)]; });
    };
    parallelForEdges(mesh, jobs, [&](EdgeId edge) {
        const auto ends = endsOf(mesh, edge);
        if (!follows(ends)) return;
        const HalfedgeId side = mesh.halfedge_handle(edge, 0);
        lattice.moveEdge(side, [&](int k) {
            const auto& value = hermite[at(k)].value;
            const Point way = value[0][0] * missing[at(ends[0])] + value[1][0] * missing[at(ends[1])];
            return lattice.point(side, k, 0) + way;
        });
    });
    parallelForFaces(mesh, jobs, [&](FaceId face) {
        const auto corners = lattice.numbers().corners(face);
        if (!follows(corners)) return;
        std::array<Point, 4> ofCorners;
        std::ranges::transform(corners, ofCorners.begin(),
                               [&](VertexId corner) { return missing[at(corner)]; });
        lattice.moveInside(face, [&](int i, int j) {
            return lattice.point(face, i, j) + betweenCorners(hermite[at(i)], hermite[at(j)], ofCorners);
        });
    });
    for (const VertexId vertex : mesh.vertices())
        lattice.move(vertex, mesh.point(vertex));
}

} // namespace qm

#include "mesh/boundary_loops.h"

#include "base/at.h"

#include <algorithm>
#include <tuple>

namespace qm {
namespace {

BoundaryLoop walk(const QuadMesh& mesh, HalfedgeId start, std::vector<bool>& seen) {
    BoundaryLoop loop{mesh.from_vertex_handle(start)};
    HalfedgeId halfedge = start;
    do {
        seen[at(halfedge)] = true;
        loop.vertex = std::min(loop.vertex, mesh.from_vertex_handle(halfedge));
        ++loop.edges;
        loop.length +=
            (mesh.point(mesh.to_vertex_handle(halfedge)) - mesh.point(mesh.from_vertex_handle(halfedge)))
                .norm();
        halfedge = mesh.next_halfedge_handle(halfedge);
    } while (halfedge != start);
    return loop;
}

} // namespace

std::vector<BoundaryLoop> boundaryLoops(const QuadMesh& mesh) {
    std::vector<BoundaryLoop> loops;
    std::vector<bool> seen(mesh.n_halfedges(), false);
    for (const HalfedgeId halfedge : mesh.halfedges())
        if (mesh.is_boundary(halfedge) && !seen[at(halfedge)]) loops.push_back(walk(mesh, halfedge, seen));
    std::ranges::sort(
        loops, {}, [](const BoundaryLoop& loop) { return std::make_tuple(-loop.length, loop.vertex.idx()); });
    return loops;
}

} // namespace qm

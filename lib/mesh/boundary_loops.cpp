#include "mesh/boundary_loops.h"

#include "base/at.h"

#include <algorithm>
#include <tuple>

namespace qm {

std::vector<std::vector<HalfedgeId>> boundaryPaths(const QuadMesh& mesh) {
    std::vector<std::vector<HalfedgeId>> paths;
    std::vector<bool> isSeen(mesh.n_halfedges());
    for (const HalfedgeId start : mesh.halfedges()) {
        if (!mesh.is_boundary(start) || isSeen[at(start)]) continue;
        std::vector<HalfedgeId>& path = paths.emplace_back();
        for (HalfedgeId next = start; !isSeen[at(next)]; next = mesh.next_halfedge_handle(next)) {
            isSeen[at(next)] = true;
            path.push_back(next);
        }
    }
    return paths;
}

std::vector<BoundaryLoop> boundaryLoops(const QuadMesh& mesh) {
    std::vector<BoundaryLoop> loops;
    for (const std::vector<HalfedgeId>& path : boundaryPaths(mesh)) {
        BoundaryLoop& loop =
            loops.emplace_back(BoundaryLoop{mesh.from_vertex_handle(path.front()), path.size()});
        for (const HalfedgeId halfedge : path) {
            loop.vertex = std::min(loop.vertex, mesh.from_vertex_handle(halfedge));
            loop.length += mesh.calc_edge_length(halfedge);
        }
    }
    std::ranges::sort(
        loops, {}, [](const BoundaryLoop& loop) { return std::make_tuple(-loop.length, loop.vertex.idx()); });
    return loops;
}

} // namespace qm

#include "support/track_along.h"

#include "base/at.h"
#include "mesh/topology.h"
#include "support/grid_layout.h"

#include <algorithm>
#include <stdexcept>

namespace qm::test {

Track trackAlong(const QuadMesh& mesh, const Path& path, double cost) {
    Track track{{}, cost};
    for (std::size_t k = 1; k < path.size(); ++k)
        track.halfedges.push_back(mesh.find_halfedge(VertexId(path[k - 1]), VertexId(path[k])));
    if (!std::ranges::all_of(track.halfedges, &HalfedgeId::is_valid))
        throw std::invalid_argument("no edge joins two vertices of the path");
    return track;
}

PerEdge& PerEdge::along(const Path& path, double value) {
    for (const HalfedgeId halfedge : trackAlong(mesh_, path).halfedges)
        values_[at(mesh_.edge_handle(halfedge))] = value;
    return *this;
}

Path pathOf(const QuadMesh& mesh, const Track& track) {
    return numbers(verticesAlong(mesh, track.halfedges));
}

QuadMesh rectangle(int columns, int rows) {
    return test::makeMesh({columns, rows, [](double x, double y) { return Point(x, y, 0); }});
}

} // namespace qm::test

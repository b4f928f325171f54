#include "support/track_along.h"

#include "base/at.h"
#include "mesh/topology.h"
#include "support/grid_layout.h"

namespace qm::testing {

Track trackAlong(const QuadMesh& mesh, const Path& path, double cost) {
    std::vector<VertexId> vertices;
    for (const int vertex : path)
        vertices.emplace_back(vertex);
    return {halfedgesAlong(mesh, vertices).value(), cost};
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

} // namespace qm::testing

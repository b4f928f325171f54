#include "mesh/soup/build_mesh.h"

#include "mesh/soup/validate.h"

namespace qm {
namespace {

VertexId vertexAt(std::int64_t index) {
    return VertexId(static_cast<int>(index));
}

/// Adds all edges, numbered in the order in which faces meet them.
/// \return the halfedge of every side
std::vector<HalfedgeId> addEdges(QuadMesh& mesh, const Soup& soup, const std::vector<Side>& twins) {
    std::vector<HalfedgeId> halfedges(twins.size());
    for (Side side = 0; side < twins.size(); ++side)
        halfedges[side] = twins[side] < side
                              ? mesh.opposite_halfedge_handle(halfedges[twins[side]])
                              : mesh.new_edge(vertexAt(sideFrom(soup, side)), vertexAt(sideTo(soup, side)));
    return halfedges;
}

void addFaces(QuadMesh& mesh, const std::vector<HalfedgeId>& halfedges) {
    for (Side side = 0; side < halfedges.size(); ++side) {
        const HalfedgeId halfedge = halfedges[side];
        if (side % 4 == 0) mesh.set_halfedge_handle(mesh.new_face(), halfedges[side + 3]);
        mesh.set_face_handle(halfedge, FaceId(static_cast<int>(side / 4)));
        mesh.set_next_halfedge_handle(halfedge, halfedges[nextSide(side)]);
        const VertexId vertex = mesh.from_vertex_handle(halfedge);
        if (mesh.is_isolated(vertex)) mesh.set_halfedge_handle(vertex, halfedge);
    }
}

/// Links the halfedges along the boundary. OpenMesh requires that the halfedge of a boundary vertex is the
/// one that leaves it along the boundary.
void linkBoundary(QuadMesh& mesh, const std::vector<Side>& twins, const std::vector<HalfedgeId>& halfedges) {
    std::vector<HalfedgeId> boundary;
    for (Side side = 0; side < twins.size(); ++side)
        if (twins[side] == twins.size()) boundary.push_back(mesh.opposite_halfedge_handle(halfedges[side]));
    for (const HalfedgeId halfedge : boundary)
        mesh.set_halfedge_handle(mesh.from_vertex_handle(halfedge), halfedge);
    for (const HalfedgeId halfedge : boundary)
        mesh.set_next_halfedge_handle(halfedge, mesh.halfedge_handle(mesh.to_vertex_handle(halfedge)));
}

} // namespace

QuadMesh buildMesh(const Soup& soup) {
    // Validation has found all neighbours already; add_face would search for them again around each vertex.
    const std::vector<Side> twins = validateSoup(soup);
    QuadMesh mesh;
    mesh.reserve(soup.points.size(), twins.size() / 2 + 1, soup.faceCount());
    for (const Point& point : soup.points)
        mesh.add_vertex(point);
    const std::vector<HalfedgeId> halfedges = addEdges(mesh, soup, twins);
    addFaces(mesh, halfedges);
    linkBoundary(mesh, twins, halfedges);
    return mesh;
}

QuadMesh buildMesh(const std::vector<Point>& points, const std::vector<std::array<int, 4>>& quads) {
    Soup soup;
    soup.points = points;
    for (const auto& quad : quads)
        soup.addFace(quad);
    return buildMesh(soup);
}

} // namespace qm

#include "mesh/topology.h"

#include "base/at.h"
#include "base/disjoint_sets.h"
#include "base/positions.h"

namespace qm {

namespace {

bool isRegularWith(const QuadMesh& mesh, VertexId vertex, unsigned edges) {
    return mesh.is_isolated(vertex) || (mesh.is_boundary(vertex) ? edges <= 3 : edges == 4);
}

} // namespace

bool isRegular(const QuadMesh& mesh, VertexId vertex) {
    constexpr unsigned enough = 5; // more need not be counted: they may be thousands
    unsigned edges = 0;
    for (auto edge = mesh.cve_iter(vertex); edge.is_valid() && edges < enough; ++edge)
        ++edges;
    return isRegularWith(mesh, vertex, edges);
}

std::vector<VertexId> extraordinaryVertices(const QuadMesh& mesh) {
    // A single pass over the edges is several times faster than a walk around every vertex.
    std::vector<unsigned> edges(mesh.n_vertices(), 0);
    for (const EdgeId edge : mesh.edges())
        for (const VertexId end : endsOf(mesh, edge))
            ++edges[at(end)];
    std::vector<VertexId> result;
    for (const VertexId vertex : mesh.vertices())
        if (!isRegularWith(mesh, vertex, edges[at(vertex)])) result.push_back(vertex);
    return result;
}

std::vector<HalfedgeId> leavingFrom(const QuadMesh& mesh, HalfedgeId first) {
    std::vector<HalfedgeId> result;
    HalfedgeId next = first;
    do {
        result.push_back(next);
        next = mesh.ccw_rotated_halfedge_handle(next);
    } while (next != first);
    return result;
}

std::vector<VertexId> verticesAlong(const QuadMesh& mesh, std::span<const HalfedgeId> halfedges) {
    std::vector<VertexId> vertices;
    if (halfedges.empty()) return vertices;
    vertices.reserve(halfedges.size() + 1);
    vertices.push_back(mesh.from_vertex_handle(halfedges.front()));
    for (const HalfedgeId halfedge : halfedges)
        vertices.push_back(mesh.to_vertex_handle(halfedge));
    return vertices;
}

double sumAlong(const QuadMesh& mesh, std::span<const HalfedgeId> path, const std::vector<double>& perEdge) {
    double sum = 0;
    for (const HalfedgeId halfedge : path)
        sum += perEdge[at(mesh.edge_handle(halfedge))];
    return sum;
}

Components components(const QuadMesh& mesh) {
    DisjointSets sets(mesh.n_vertices());
    for (const EdgeId edge : mesh.edges()) {
        const auto [one, other] = endsOf(mesh, edge);
        sets.join(at(one), at(other));
    }
    Components result;
    result.ofVertex.resize(mesh.n_vertices());
    for (std::size_t k = 0; k < result.ofVertex.size(); ++k) { // the lowest vertex of a set comes first
        const std::size_t lowest = sets.find(k);
        result.ofVertex[k] = lowest == k ? result.count++ : result.ofVertex[lowest];
    }
    return result;
}

std::size_t pieceCount(const QuadMesh& mesh) {
    const auto isIsolated = [&](VertexId vertex) { return mesh.is_isolated(vertex); };
    return at(components(mesh).count) - countWhere(mesh.vertices(), isIsolated);
}

} // namespace qm

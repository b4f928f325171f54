#include "layout/cost.h"

#include "mesh/topology.h"

namespace qm {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

bool counts(VertexId vertex, const std::vector<int>& labels, int label) {
    return labels.empty() || labels[at(vertex.idx())] == label;
}

} // namespace

std::vector<double> edgeCosts(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                              const GraphCost& cost, const Constraints& constraints) {
    std::vector<double> costs = edgeCosts(dihedralAngles, cost);
    if (cost.terms.dihedral != 1)
        for (double& each : costs)
            each *= cost.terms.dihedral;
    if (cost.terms.length != 0)
        for (const EdgeId edge : mesh.edges())
            if (!mesh.is_boundary(edge))
                costs[at(edge.idx())] += cost.terms.length * mesh.calc_edge_length(edge);
    for (const auto& [edge, weight] : constraints.weights)
        costs[at(edge.idx())] += cost.terms.custom * weight;
    return costs;
}

std::size_t countCorners(const QuadMesh& mesh, const std::vector<bool>& edges, const std::vector<int>& labels,
                         int label) {
    const auto bounds = [&](HalfedgeId halfedge) {
        const EdgeId edge = mesh.edge_handle(halfedge);
        return edges[at(edge.idx())] || mesh.is_boundary(edge);
    };
    std::size_t corners = 0;
    for (const HalfedgeId halfedge : mesh.halfedges())
        if (!mesh.is_boundary(halfedge) && counts(mesh.to_vertex_handle(halfedge), labels, label))
            corners += bounds(halfedge) && bounds(mesh.next_halfedge_handle(halfedge)) ? 1 : 0;
    return corners;
}

double costOfCorners(const QuadMesh& mesh, const CostTerms& terms, const std::vector<Track>& tracks,
                     const std::vector<int>& labels, int label) {
    if (terms.segments == 0) return 0;
    std::vector<bool> edges(mesh.n_edges(), false);
    for (const Track& track : tracks)
        for (const HalfedgeId halfedge : track.halfedges)
            edges[at(mesh.edge_handle(halfedge).idx())] = true;
    return cornerCost(terms) * static_cast<double>(countCorners(mesh, edges, labels, label));
}

std::size_t countSureCorners(const QuadMesh& mesh, const std::vector<int>& labels, int label) {
    std::size_t corners = 0;
    for (const VertexId vertex : mesh.vertices()) {
        if (!counts(vertex, labels, label)) continue;
        std::size_t faces = 0;
        for (const FaceId face : mesh.vf_range(vertex))
            faces += face.is_valid() ? 1 : 0;
        if (!isRegular(mesh, vertex) || (mesh.is_boundary(vertex) && faces == 1)) corners += faces;
    }
    return corners;
}

} // namespace qm

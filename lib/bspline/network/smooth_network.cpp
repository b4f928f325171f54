#include "bspline/network/smooth_network.h"

#include "base/at.h"
#include "bspline/network/creases.h"
#include "bspline/network/vertex_fan.h"
#include "mesh/topology.h"

#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// By halfedge: the tangent ratio at the vertex that it leaves, of smooth borders; otherwise 0.
std::vector<double> ratiosAtVertices(const QuadMesh& mesh, const SmoothNetwork& network,
                                     const std::vector<BorderEdge>& borders) {
    std::vector<double> ratios(mesh.n_halfedges());
    std::vector<bool> seen(mesh.n_vertices());
    for (const BorderEdge& border : borders)
        for (const VertexId vertex : endsOf(mesh, border.halfedge)) {
            const std::size_t index = at(vertex);
            if (seen[index]) continue;
            seen[index] = true;
            const VertexFan fan = vertexFan(mesh, network.marks, vertex);
            const auto all = tangentRatios(mesh, fan, network.rules[index]);
            for (std::size_t k = 0; k < all.size(); ++k)
                ratios[at(fan.borders[k])] = all[k];
        }
    return ratios;
}

/// The runs of smooth edges, each as far as all tangent ratios at the vertices inside are zero.
std::vector<SmoothRun> smoothRuns(const QuadMesh& mesh, const SmoothNetwork& network,
                                  const std::vector<double>& ratios) {
    const auto isSmooth = [&](HalfedgeId halfedge) {
        return !network.marks.isCrease[at(mesh.edge_handle(halfedge))];
    };
    const auto ratioAtBegin = [&](HalfedgeId halfedge) { return ratios[at(halfedge)]; };
    // There an edge comes to the vertex, where the ratio is meant for what leaves.
    const auto ratioAtEnd = [&](HalfedgeId halfedge) {
        return -ratios[at(mesh.opposite_halfedge_handle(halfedge))];
    };
    std::vector<SmoothRun> runs;
    for (std::size_t k = 0; k < network.stretches.size(); ++k) {
        const auto& halfedges = network.stretches[k].halfedges;
        for (std::size_t edge = 0; edge < halfedges.size(); ++edge) {
            if (!isSmooth(halfedges[edge])) continue;
            const bool goesOn = edge > 0 && isSmooth(halfedges[edge - 1]) &&
                                ratioAtEnd(halfedges[edge - 1]) == 0 && ratioAtBegin(halfedges[edge]) == 0;
            if (!goesOn) {
                SmoothRun& run = runs.emplace_back();
                run.stretch = k;
                run.begin = static_cast<int>(edge);
                run.ratio.atEnd[0] = ratioAtBegin(halfedges[edge]);
            }
            runs.back().end = static_cast<int>(edge) + 1;
            runs.back().ratio.atEnd[1] = ratioAtEnd(halfedges[edge]);
        }
    }
    for (SmoothRun& run : runs)
        run.ratio.length = run.end - run.begin;
    return runs;
}

} // namespace

SmoothNetwork buildNetwork(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho) {
    const auto borders = borderEdges(mesh, layout);
    SmoothNetwork network{markBorders(mesh, borders, dihedralAngles, rho), {}, findStretches(borders), {}};
    network.rules = vertexRules(mesh, layout, network.marks.isCrease);
    network.runs = smoothRuns(mesh, network, ratiosAtVertices(mesh, network, borders));
    return network;
}

} // namespace qm

#include "bspline/network/smooth_network.h"

#include "base/at.h"
#include "bspline/network/borders.h"
#include "bspline/network/creases.h"
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

} // namespace

SmoothNetwork buildNetwork(const QuadMesh& mesh, const Layout& layout,
                           const std::vector<double>& dihedralAngles, double rho) {
    const auto borders = borderEdges(mesh, layout);
    SmoothNetwork network{markBorders(mesh, borders, dihedralAngles, rho), {}, findStretches(borders), {}};
    network.rules = vertexRules(mesh, layout, network.marks.isCrease);
    const auto ratios = ratiosAtVertices(mesh, network, borders);
    const auto ratioAt = [&](HalfedgeId leaving) { return ratios[at(leaving)]; };
    const auto isSmooth = [&](HalfedgeId halfedge) {
        return !network.marks.isCrease[at(mesh.edge_handle(halfedge))];
    };
    for (std::size_t k = 0; k < network.stretches.size(); ++k) {
        const auto& halfedges = network.stretches[k].halfedges;
        for (std::size_t begin = 0; begin < halfedges.size();) {
            if (!isSmooth(halfedges[begin])) {
                ++begin;
                continue;
            }
            std::size_t end = begin + 1;
            const auto leaves = [&](std::size_t at) {
                return ratioAt(halfedges[at]) != 0 ||
                       ratioAt(mesh.opposite_halfedge_handle(halfedges[at - 1])) != 0;
            };
            while (end < halfedges.size() && isSmooth(halfedges[end]) && !leaves(end))
                ++end;
            SmoothRun run{k, static_cast<int>(begin), static_cast<int>(end), {}};
            run.ratio.length = static_cast<double>(end - begin);
            // At its end the run comes to the vertex, where the ratio is meant for what leaves.
            run.ratio.atEnd = {ratioAt(halfedges[begin]),
                               -ratioAt(mesh.opposite_halfedge_handle(halfedges[end - 1]))};
            network.runs.push_back(run);
            begin = end;
        }
    }
    return network;
}

} // namespace qm

#include "features/features.h"

#include "base/at.h"
#include "features/line_curves.h"
#include "mesh/bounding_box.h"
#include "mesh/mesh_lines.h"
#include "mesh/topology.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace qm {
namespace {

/// Sets the curve's seed to the admissible vertex nearest to its middle.
/// \return false if no vertex is admissible
bool placeSeed(const QuadMesh& mesh, FeatureCurve& curve, std::vector<bool>& taken) {
    const std::vector<VertexId> vertices = verticesAlong(mesh, curve.halfedges);
    const int middle = static_cast<int>(curve.halfedges.size()) / 2;
    std::vector<int> order(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int k) { return std::abs(k - middle); });
    for (const int k : order) {
        const VertexId vertex = vertices[at(k)];
        if (taken[at(vertex)] || !continuesStraight(mesh, vertex)) continue;
        taken[at(vertex)] = true;
        curve.seed = vertex;
        return true;
    }
    return false;
}

} // namespace

Features findFeatures(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                      const FeatureOptions& options) {
    const double diagonal = boundingBox(mesh).diagonal();
    const SharpMesh sharp{mesh, dihedralAngles, options, options.minLength.length(diagonal),
                          options.minDistance.length(diagonal)};
    std::vector<FeatureCurve> curves;
    forEachMeshLine(mesh, [&](const MeshLine& line) { addCurvesOf(line, sharp, curves); });
    const auto edgeNumber = [&](HalfedgeId halfedge) { return mesh.edge_handle(halfedge).idx(); };
    std::ranges::sort(curves, {}, [&](const FeatureCurve& curve) {
        return edgeNumber(*std::ranges::min_element(curve.halfedges, {}, edgeNumber));
    });
    Features features;
    std::vector<bool> taken(mesh.n_vertices(), false);
    for (FeatureCurve& curve : curves)
        if (placeSeed(mesh, curve, taken)) features.curves.push_back(std::move(curve));
    return features;
}

std::vector<Seed> seeds(const QuadMesh& mesh, const Features& features) {
    std::vector<Seed> result;
    for (const FeatureCurve& curve : features.curves) {
        const auto leaving = std::ranges::find(curve.halfedges, curve.seed,
                                               [&](HalfedgeId h) { return mesh.from_vertex_handle(h); });
        result.push_back({leaving != curve.halfedges.end()
                              ? *leaving
                              : mesh.opposite_halfedge_handle(curve.halfedges.back())});
    }
    return result;
}

} // namespace qm

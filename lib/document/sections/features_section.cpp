#include "document/sections/features_section.h"

#include "base/at.h"
#include "document/options/options_json.h"
#include "document/sections/mesh_paths.h"
#include "mesh/topology.h"

#include <algorithm>
#include <vector>

namespace qm {

Json featuresToJson(const QuadMesh& mesh, const Features& features, const FeatureOptions& options) {
    Json section = optionsToJson(options);
    Json::array_t curves;
    for (const FeatureCurve& curve : features.curves)
        curves.push_back({{"id", curves.size()},
                          {"vertices", pathNumbers(mesh, curve.halfedges)},
                          {"seed", curve.seed.idx()}});
    section["curves"] = std::move(curves);
    return section;
}

namespace {

void verifySeed(const QuadMesh& mesh, const FeatureCurve& curve, const JsonPlace& place) {
    if (std::ranges::count(verticesAlong(mesh, curve.halfedges), curve.seed) == 0)
        place.fail("vertex " + std::to_string(curve.seed.idx()) + " is not on the curve");
    if (!continuesStraight(mesh, curve.seed))
        place.fail("vertex " + std::to_string(curve.seed.idx()) + " is no interior regular vertex",
                   "Choose another vertex of the curve");
}

} // namespace

Features readFeatures(const QuadMesh& mesh, const JsonPlace& section) {
    Features features;
    std::vector<bool> onCurve(mesh.n_edges()), seeded(mesh.n_vertices());
    const JsonPlace curves = section["curves"];
    verifyDistinctIds(curves);
    for (const JsonPlace& place : curves.elements()) {
        FeatureCurve curve;
        curve.halfedges = pathAt(mesh, place["vertices"]);
        requireStraight(mesh, curve.halfedges, place["vertices"]);
        curve.seed = vertexAt(mesh, place["seed"]);
        verifySeed(mesh, curve, place["seed"]);
        for (std::size_t i = 0; i < curve.halfedges.size(); ++i) {
            const std::size_t edge = at(mesh.edge_handle(curve.halfedges[i]));
            if (onCurve[edge])
                place["vertices"].failAt(i + 1, "the edge to this vertex lies on a curve already");
            onCurve[edge] = true;
        }
        if (seeded[at(curve.seed)])
            place["seed"].fail("another curve has its seed there", "Choose another vertex of the curve");
        seeded[at(curve.seed)] = true;
        features.curves.push_back(std::move(curve));
    }
    return features;
}

double sharpAngle(const Json& root) {
    const double standard = FeatureOptions{}.rho;
    const auto section = root.find("features");
    if (section == root.end() || !section->is_object()) return standard;
    const auto rho = section->find("rho");
    return rho != section->end() && rho->is_number() ? rho->get<double>() : standard;
}

} // namespace qm

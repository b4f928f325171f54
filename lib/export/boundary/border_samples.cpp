#include "export/boundary/border_samples.h"

#include "bspline/splines/eigen_point.h"
#include "bspline/splines/evaluate.h"
#include "layout/sides.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

constexpr int perMeshEdge = 4; ///< steps between samples
/// How far from the ends of a border, where a patch may have no normal, samples are, in mesh edges.
constexpr double fromEnds = 0.005;

/// A point of a side of a patch, at a distance from its beginning.
SurfacePoint onSide(const Patch& patch, int side, double along) {
    const auto [u, v] = domain(patch);
    const auto at = placeOnSide(std::array{u[1], v[1]}, side, along);
    return evaluate(patch, at[0], at[1]);
}

} // namespace

std::vector<SmoothBorder> smoothBorders(const std::vector<Patch>& clampedPatches, const SharedEdges& shared,
                                        double smoothAngle) {
    std::vector<SmoothBorder> result;
    for (const SharedEdge& edge : shared.edges) {
        if (edge.places.size() != 2 || !(edge.angle < smoothAngle)) continue;
        const auto& [one, other] = std::array{edge.places[0], edge.places[1]};
        SmoothBorder& border = result.emplace_back();
        border.patches = {one.patch, other.patch};
        for (int k = 0; k <= edge.length * perMeshEdge; ++k) {
            const double along =
                std::clamp(static_cast<double>(k) / perMeshEdge, fromEnds, edge.length - fromEnds);
            const SurfacePoint here = onSide(clampedPatches[one.patch], one.side, one.position + along);
            // The second patch walks the edge the other way.
            const SurfacePoint there =
                onSide(clampedPatches[other.patch], other.side, other.position + edge.length - along);
            const auto normal = unitNormal(here.du, here.dv);
            const auto beside = unitNormal(there.du, there.dv);
            if (!normal || !beside) continue;
            border.points.push_back(vector(here.position));
            border.normals[0].push_back(vector(*normal));
            border.normals[1].push_back(vector(*beside));
        }
    }
    return result;
}

} // namespace qm

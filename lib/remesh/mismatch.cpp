#include "remesh/mismatch.h"

#include "base/infinity.h"
#include "base/parallel.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "mesh/quad_geometry.h"
#include "remesh/surface_samples.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

/// \param pointOf  of a number below `count`
template <class PointOf>
std::vector<double> distancesFrom(const TriangleSurface& surface, std::size_t count, const PointOf& pointOf,
                                  unsigned jobs) {
    std::vector<double> distances(count);
    parallelForMany(count, jobs, [&](std::size_t k) {
        const auto nearest = surface.nearest(pointOf(k));
        distances[k] = nearest ? nearest->distance : infinity;
    });
    return distances;
}

} // namespace

Mismatch mismatchOf(const QuadMesh& mesh, const Triangles& scan, unsigned jobs) {
    constexpr double tooFar = 2;             // edges
    constexpr std::size_t samplesOfQuad = 4; // of very fine scans
    const double edge = meanEdgeLength(mesh);
    const double reach = tooFar * edge;
    Mismatch result;
    const auto samples = samplesOfScan(scan, edge * edge, samplesOfQuad * mesh.n_faces());
    const auto ofScan = distancesFrom(
        TriangleSurface(halves(mesh)), samples.size(), [&](std::size_t k) { return samples[k].position; },
        jobs);
    double area = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        area += samples[k].area;
        if (ofScan[k] <= reach) continue;
        result.missing += samples[k].area;
        if (ofScan[k] <= result.missingDistance) continue;
        result.missingDistance = ofScan[k];
        result.missingAt = samples[k].position;
    }
    if (area > 0) result.missing /= area;
    const auto vertexAt = [&](std::size_t k) { return mesh.point(VertexId(static_cast<int>(k))); };
    const auto ofVertices = distancesFrom(TriangleSurface(scan), mesh.n_vertices(), vertexAt, jobs);
    for (std::size_t k = 0; k < ofVertices.size(); ++k)
        if (ofVertices[k] > std::max(reach, result.strayed) &&
            !mesh.is_isolated(VertexId(static_cast<int>(k)))) {
            result.strayed = ofVertices[k];
            result.strayedAt = vertexAt(k);
        }
    return result;
}

} // namespace qm

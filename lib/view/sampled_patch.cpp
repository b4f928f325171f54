#include "view/sampled_patch.h"

#include "base/parallel.h"
#include "bspline/measure/mesh_distance.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// What a graphics card draws at ease.
constexpr double maxSamples = 200000;
constexpr double maxSteps = 8;

std::vector<double> parameters(int quads, std::size_t steps) {
    std::vector<double> result;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(quads) * steps; ++k)
        result.push_back(static_cast<double>(k) / static_cast<double>(steps));
    return result;
}

/// The point of the mesh that has the parameters (u, v) in a segment.
Point onMesh(const QuadMesh& mesh, const std::vector<VertexId>& grid, const Segment& segment, double u,
             double v) {
    const auto width = static_cast<std::size_t>(segment.size[0]) + 1;
    const double i = std::min(std::floor(u), segment.size[0] - 1.0);
    const double j = std::min(std::floor(v), segment.size[1] - 1.0);
    const std::size_t corner = static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
    return bilinear({mesh.point(grid[corner]), mesh.point(grid[corner + 1]),
                     mesh.point(grid[corner + width + 1]), mesh.point(grid[corner + width])},
                    u - i, v - j);
}

} // namespace

std::vector<SampledPatch> samplePatches(const QuadMesh& mesh, const Layout& layout,
                                        const std::vector<Patch>& patches, unsigned jobs) {
    const double faces = std::max(1.0, static_cast<double>(mesh.n_faces()));
    const auto steps =
        static_cast<std::size_t>(std::clamp(std::floor(std::sqrt(maxSamples / faces)), 1.0, maxSteps));
    const MeshDistance distance(mesh);
    std::vector<SampledPatch> result(patches.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        const Segment& segment = layout.segments[k];
        const auto us = parameters(segment.size[0], steps);
        const auto vs = parameters(segment.size[1], steps);
        const auto grid = vertexGrid(mesh, segment);
        SampledPatch& patch = result[k];
        patch = {us.size(), vs.size(), steps, evaluateLattice(patches[k], us, vs), {}};
        for (std::size_t i = 0; i < patch.points.size(); ++i) {
            const Point& point = patch.points[i].position;
            const Point near = onMesh(mesh, grid, segment, us[i % us.size()], vs[i / us.size()]);
            patch.distances.push_back(distance(point, (point - near).norm()));
        }
    });
    return result;
}

} // namespace qm

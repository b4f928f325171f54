#include "bspline/reference/lattice/lattice_normals.h"

#include "base/parallel.h"
#include "bspline/reference/lattice/lattice_numbers.h"

#include <Eigen/Geometry>

namespace qm {
namespace {

std::vector<std::optional<Eigen::Vector3d>> normalsOf(const ReferenceGrid& grid) {
    std::vector<std::optional<Eigen::Vector3d>> normals;
    normals.reserve(grid.points.size());
    for (int j = 0; j <= grid.size[1] * grid.steps; ++j)
        for (int i = 0; i <= grid.size[0] * grid.steps; ++i) {
            const SurfacePoint at =
                grid.evaluate(static_cast<double>(i) / grid.steps, static_cast<double>(j) / grid.steps);
            const Eigen::Vector3d normal = vector(at.du).cross(vector(at.dv)).stableNormalized();
            normals.push_back(normal.isZero(0) ? std::nullopt : std::optional(normal));
        }
    return normals;
}

} // namespace

LatticeNormals latticeNormals(const QuadMesh& mesh, const Layout& layout,
                              const std::vector<ReferenceGrid>& surface, unsigned jobs) {
    constexpr double sameCosine = 0.995; // six degrees from their mean
    LatticeNormals result;
    if (surface.empty()) return result;
    const LatticeNumbers numbers(mesh, surface.front().steps);
    result.numbers.resize(surface.size());
    result.oneSided.resize(surface.size());
    parallelFor(surface.size(), jobs, [&](std::size_t g) {
        result.numbers[g] = numbers.ofSegment(layout.segments[g]);
        result.oneSided[g] = normalsOf(surface[g]);
    });
    result.points.assign(numbers.count(), Eigen::Vector3d::Zero());
    result.normals.resize(numbers.count());
    result.sharp.assign(numbers.count(), false);
    std::vector<Eigen::Vector3d> means = result.points;
    result.forEachPoint([&](std::size_t g, std::size_t k, std::size_t number) {
        result.points[number] = vector(surface[g].points[k]);
        if (const auto& normal = result.oneSided[g][k]) means[number] += *normal;
    });
    for (Eigen::Vector3d& mean : means)
        mean.stableNormalize();
    result.forEachPoint([&](std::size_t g, std::size_t k, std::size_t number) {
        const auto& normal = result.oneSided[g][k];
        if (!normal || normal->dot(means[number]) < sameCosine) result.sharp[number] = true;
    });
    for (std::size_t number = 0; number < means.size(); ++number)
        if (!result.sharp[number] && !means[number].isZero(0)) result.normals[number] = means[number];
    return result;
}

} // namespace qm

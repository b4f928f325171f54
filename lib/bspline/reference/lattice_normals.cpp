#include "bspline/reference/lattice_normals.h"

#include "base/parallel.h"
#include "bspline/reference/lattice_numbers.h"

#include <Eigen/Geometry>

namespace qm {
namespace {

std::vector<Eigen::Vector3d> normalsOf(const ReferenceGrid& grid) {
    std::vector<Eigen::Vector3d> normals;
    normals.reserve(grid.points.size());
    for (int j = 0; j <= grid.size[1] * grid.steps; ++j)
        for (int i = 0; i <= grid.size[0] * grid.steps; ++i) {
            const SurfacePoint at =
                grid.evaluate(static_cast<double>(i) / grid.steps, static_cast<double>(j) / grid.steps);
            normals.push_back(vector(at.du).cross(vector(at.dv)).stableNormalized());
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
    result.normals = result.points;
    result.sharp.assign(numbers.count(), false);
    result.used = result.sharp;
    for (std::size_t g = 0; g < surface.size(); ++g)
        for (std::size_t k = 0; k < result.numbers[g].size(); ++k) {
            const std::size_t number = result.numbers[g][k];
            result.points[number] = vector(surface[g].points[k]);
            result.normals[number] += result.oneSided[g][k];
            result.used[number] = true;
        }
    for (Eigen::Vector3d& normal : result.normals)
        normal.stableNormalize();
    for (std::size_t g = 0; g < surface.size(); ++g)
        for (std::size_t k = 0; k < result.numbers[g].size(); ++k) {
            const std::size_t number = result.numbers[g][k];
            if (result.oneSided[g][k].dot(result.normals[number]) < sameCosine) result.sharp[number] = true;
        }
    return result;
}

} // namespace qm

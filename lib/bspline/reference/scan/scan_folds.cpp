#include "bspline/reference/scan/scan_folds.h"

#include "base/at.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>

namespace qm {
namespace {

/// Largest number of passes: dropping targets may make neighbouring cells fold.
constexpr int maxPasses = 8;

/// The numbers in its grid of a cell's points, all around.
using Cell = std::array<std::size_t, 4>;

bool turnsOver(const ReferenceGrid& before, const ReferenceGrid& after, const Cell& cell) {
    const auto corner = [&cell](const ReferenceGrid& grid, std::size_t k) -> Eigen::Vector3d {
        const Point& own = grid.points[cell[k]];
        return vector(grid.points[cell[(k + 1) % 4]] - own)
            .cross(vector(grid.points[cell[(k + 3) % 4]] - own));
    };
    const Eigen::Vector3d normal = vector(before.points[cell[2]] - before.points[cell[0]])
                                       .cross(vector(before.points[cell[3]] - before.points[cell[1]]));
    for (std::size_t k = 0; k < cell.size(); ++k)
        if (corner(before, k).dot(normal) > 0 && corner(after, k).dot(normal) <= 0) return true;
    return false;
}

} // namespace

void dropFolded(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface,
                FitTarget& reference) {
    std::vector<bool> isDropped(lattice.points.size());
    for (int pass = 0; pass < maxPasses; ++pass) {
        bool hasDropped = false;
        for (std::size_t g = 0; g < surface.size(); ++g) {
            const std::size_t row = surface[g].columns();
            for (std::size_t first = 0; first + row + 1 < surface[g].points.size(); ++first) {
                const Cell cell{first, first + 1, first + row + 1, first + row};
                if (first % row + 1 == row || !turnsOver(surface[g], reference.grids[g], cell)) continue;
                for (const std::size_t k : cell) {
                    const std::size_t number = lattice.numbers[g][k];
                    hasDropped = hasDropped || !isDropped[number];
                    isDropped[number] = true;
                }
            }
        }
        if (!hasDropped) return;
        lattice.forEachPoint([&](std::size_t g, std::size_t k, std::size_t number) {
            if (!isDropped[number]) return;
            reference.grids[g].points[k] = surface[g].points[k];
            reference.weights[g][k] = 0;
        });
    }
}

} // namespace qm

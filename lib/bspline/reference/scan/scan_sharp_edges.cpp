#include "bspline/reference/scan/scan_sharp_edges.h"

#include <Eigen/Dense>

#include <algorithm>
#include <map>

namespace qm {
namespace {

/// The offset at the end of a grid, from the straight line through the next few inside it.
std::optional<double> extrapolated(const ScanTargets& targets, std::size_t g, int i, int j) {
    constexpr int pointsPerSide = 4;
    const int right = i == 0 ? 1 : i == targets.columns(g) ? -1 : 0;
    const int down = j == 0 ? 1 : j == targets.rows(g) ? -1 : 0;
    double count = 0, places = 0, squares = 0, values = 0, moments = 0;
    for (int k = 1; k <= pointsPerSide; ++k) {
        const auto value = targets.offset(g, i + k * right, j + k * down);
        if (!value) continue;
        count += 1, places += k, squares += k * k, values += *value, moments += k * *value;
    }
    if (count == 0) return std::nullopt;
    if (count < 3) return values / count; // too few to know a slope from noise
    return (squares * values - places * moments) / (count * squares - places * places);
}

/// Along directions in which the planes do not meet, the point stays.
Eigen::Vector3d shortestSolution(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    const double smallest = 0.05 * solver.eigenvalues()[2];
    Eigen::Vector3d solution = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        if (const double value = solver.eigenvalues()[k]; value > smallest) {
            const Eigen::Vector3d direction = solver.eigenvectors().col(k);
            solution += direction * (direction.dot(right) / value);
        }
    return solution;
}

} // namespace

void extrapolateToSharpEdges(ScanTargets& targets, const TriangleSurface& scan, double maxDistance,
                             double maxRounding) {
    struct Planes {
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        bool complete = true;
    };
    std::map<std::size_t, Planes> ofSharp; // by lattice point
    targets.forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
        if (!targets.lattice.sharp[number]) return;
        Planes& planes = ofSharp[number];
        const auto offset = extrapolated(targets, g, i, j);
        planes.complete = planes.complete && offset.has_value();
        if (const auto& normal = targets.lattice.oneSided[g][targets.index(g, i, j)]) {
            planes.matrix += *normal * normal->transpose();
            planes.right += offset.value_or(0) * *normal;
        }
    });
    for (const auto& [number, planes] : ofSharp) {
        if (!planes.complete) continue;
        const Eigen::Vector3d& from = targets.lattice.points[number];
        Eigen::Vector3d moved = shortestSolution(planes.matrix, planes.right);
        const auto nearest = scan.nearest(point(from), maxDistance);
        if (!nearest) continue;
        const double reach = std::min(1.1 * nearest->distance, maxRounding) + 3 * targets.noise;
        if (!scan.nearest(point(from + moved), reach)) {
            if (nearest->onBoundary) continue;
            moved = vector(nearest->position) - from;
        }
        targets.displacements[number] = moved;
        targets.weights[number] = 1;
    }
}

} // namespace qm

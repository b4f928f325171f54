#include "bspline/reference/scan_reference.h"

#include "base/at.h"
#include "bspline/reference/lattice_normals.h"
#include "bspline/reference/scan_folds.h"
#include "bspline/reference/scan_gaps.h"
#include "bspline/reference/scan_projection.h"
#include "bspline/reference/scan_smoothing.h"
#include "mesh/quad_geometry.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace qm {
namespace {

double median(std::vector<double>& values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Times the median of sizes: the standard deviation of a normal distribution.
constexpr double deviations = 1.4826;

/// Standard deviations at which Tukey's biweight ends, as is usual.
constexpr double biweightEnd = 4.685;

/// Targets while they are made: everything by lattice point, looked at grid by grid.
class Targets {
public:
    Targets(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface,
            std::vector<Displacement> displacements)
        : lattice_(lattice), surface_(surface), displacements_(std::move(displacements)) {
        weights_.reserve(displacements_.size());
        for (const Displacement& displacement : displacements_)
            weights_.push_back(displacement ? 1.0 : 0.0);
    }

    /// \param step  a length below which differences between neighbours are no sign of an outlier
    void weighOutliers(double step) {
        std::vector<double> sizes;
        for (const double residual : residualsOfAll(1))
            if (std::isfinite(residual)) sizes.push_back(residual);
        noise_ = deviations * median(sizes);
        const std::vector<double> residuals = residualsOfAll(2); // spikes are wider than a point
        const std::vector<double> usual = usualResiduals(residuals);
        for (std::size_t k = 0; k < residuals.size(); ++k) {
            const double end = biweightEnd * std::max({noise_, deviations * usual[k], step});
            const double share = residuals[k] / end;
            weights_[k] *= share < 1 ? (1 - share * share) * (1 - share * share) : 0;
        }
    }

    /// Sharp points go where their sides meet, unless that is farther from the scan than they are already,
    /// beyond what noise explains: then the sides bend, and the nearest point of the scan is better.
    /// \param maxRounding  how far at most a scan's edge is from the sharp one
    void carryOnToSharpEdges(const TriangleSurface& scan, double maxDistance, double maxRounding) {
        struct Planes {
            Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
            Eigen::Vector3d right = Eigen::Vector3d::Zero();
            bool complete = true;
        };
        std::vector<std::size_t> place(lattice_.points.size());
        std::vector<std::size_t> sharp;
        for (std::size_t number = 0; number < place.size(); ++number)
            if (lattice_.sharp[number]) place[number] = sharp.size(), sharp.push_back(number);
        std::vector<Planes> all(sharp.size());
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            if (!lattice_.sharp[number]) return;
            Planes& planes = all[place[number]];
            const auto offset = carriedOn(g, i, j);
            planes.complete = planes.complete && offset.has_value();
            if (const auto& normal = lattice_.oneSided[g][index(g, i, j)]) {
                planes.matrix += *normal * normal->transpose();
                planes.right += offset.value_or(0) * *normal;
            }
        });
        for (std::size_t k = 0; k < sharp.size(); ++k) {
            if (!all[k].complete) continue;
            const Eigen::Vector3d& from = lattice_.points[sharp[k]];
            Eigen::Vector3d moved = shortestSolution(all[k].matrix, all[k].right);
            const auto nearest = scan.nearest(point(from), maxDistance);
            if (!nearest) continue;
            const double reach = std::min(1.1 * nearest->distance, maxRounding) + 3 * noise_;
            if (!scan.nearest(point(from + moved), reach)) {
                if (nearest->onBoundary) continue;
                moved = vector(nearest->position) - from;
            }
            displacements_[sharp[k]] = moved;
            weights_[sharp[k]] = 1;
        }
    }

    /// A sharp point that jumps out from its neighbours along the edge has no target.
    void dropSharpOutliers(double step) {
        constexpr int reach = 3;
        std::vector<double> residuals(weights_.size(), std::numeric_limits<double>::infinity());
        const auto compare = [&](std::size_t g, int i, int j, int right, int down, std::size_t number) {
            std::array<std::vector<double>, 3> around;
            for (int k = -reach; k <= reach; ++k) {
                const int column = i + k * right;
                const int row = j + k * down;
                if (column < 0 || row < 0 || column > columns(g) || row > rows(g)) continue;
                const std::size_t other = lattice_.numbers[g][index(g, column, row)];
                if (!lattice_.sharp[other] || weights_[other] <= 0) continue;
                for (int axis = 0; axis < 3; ++axis)
                    around[at(axis)].push_back((*displacements_[other])[axis]);
            }
            const Eigen::Vector3d usual(median(around[0]), median(around[1]), median(around[2]));
            residuals[number] = std::min(residuals[number], (*displacements_[number] - usual).norm());
        };
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            if (!lattice_.sharp[number] || weights_[number] <= 0) return;
            if (j == 0 || j == rows(g)) compare(g, i, j, 1, 0, number);
            if (i == 0 || i == columns(g)) compare(g, i, j, 0, 1, number);
        });
        for (std::size_t k = 0; k < residuals.size(); ++k)
            if (std::isfinite(residuals[k]) && residuals[k] > biweightEnd * std::max(noise_, step))
                weights_[k] = 0;
    }

    /// Share of the smooth points for which the scan shows one.
    [[nodiscard]] double coverage() const {
        double all = 0;
        double covered = 0;
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            if (!lattice_.normals[k]) continue;
            ++all;
            covered += weights_[k] > 0 ? 1 : 0;
        }
        return all > 0 ? covered / all : 0;
    }

    [[nodiscard]] ScanReference result() const {
        ScanReference result{surface_, {}};
        for (const ReferenceGrid& grid : surface_)
            result.weights.emplace_back(grid.points.size());
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            if (weights_[number] <= 0) return;
            result.grids[g].points[index(g, i, j)] = point(lattice_.points[number] + *displacements_[number]);
            result.weights[g][index(g, i, j)] = weights_[number];
        });
        result.noise = noise_;
        return result;
    }

    /// Takes over what has been made of the result.
    void update(const ScanReference& result) {
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            const std::size_t at = index(g, i, j);
            displacements_[number] = vector(result.grids[g].points[at]) - lattice_.points[number];
            weights_[number] = result.weights[g][at];
        });
    }

private:
    [[nodiscard]] int columns(std::size_t g) const { return surface_[g].size[0] * surface_[g].steps; }
    [[nodiscard]] int rows(std::size_t g) const { return surface_[g].size[1] * surface_[g].steps; }
    [[nodiscard]] std::size_t index(std::size_t g, int i, int j) const {
        return at(j) * at(columns(g) + 1) + at(i);
    }

    template <class Function> void forEachPoint(const Function& f) const {
        for (std::size_t g = 0; g < surface_.size(); ++g)
            for (int j = 0; j <= rows(g); ++j)
                for (int i = 0; i <= columns(g); ++i)
                    f(g, i, j, lattice_.numbers[g][index(g, i, j)]);
    }

    /// How far the scan is above a point of a grid, if it has a target.
    [[nodiscard]] std::optional<double> offset(std::size_t g, int i, int j) const {
        if (i < 0 || j < 0 || i > columns(g) || j > rows(g)) return std::nullopt;
        const std::size_t number = lattice_.numbers[g][index(g, i, j)];
        if (weights_[number] <= 0 || lattice_.sharp[number]) return std::nullopt;
        return displacements_[number]->dot(*lattice_.oneSided[g][index(g, i, j)]);
    }

    /// How far every point is from the median of those around it, up to so many lattice steps away: the
    /// smaller value, where it is in two grids; infinite where it has no target.
    [[nodiscard]] std::vector<double> residualsOfAll(int reach) const {
        std::vector<double> residuals(weights_.size(), std::numeric_limits<double>::infinity());
        std::vector<double> around;
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            const auto own = offset(g, i, j);
            if (!own) return;
            around.clear();
            for (int down = -reach; down <= reach; ++down)
                for (int right = -reach; right <= reach; ++right)
                    if (const auto other = offset(g, i + right, j + down)) around.push_back(*other);
            residuals[number] = std::min(residuals[number], std::abs(*own - median(around)));
        });
        return residuals;
    }

    /// The median of the residuals around every point: what is usual in a rough place is no outlier. The
    /// smaller value, where it is in two grids.
    [[nodiscard]] std::vector<double> usualResiduals(const std::vector<double>& residuals) const {
        constexpr int reach = 2;
        std::vector<double> usual(residuals.size(), std::numeric_limits<double>::infinity());
        std::vector<double> around;
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            if (weights_[number] <= 0) return;
            around.clear();
            for (int down = std::max(j - reach, 0); down <= std::min(j + reach, rows(g)); ++down)
                for (int right = std::max(i - reach, 0); right <= std::min(i + reach, columns(g)); ++right) {
                    const std::size_t other = lattice_.numbers[g][index(g, right, down)];
                    if (weights_[other] > 0 && !lattice_.sharp[other]) around.push_back(residuals[other]);
                }
            usual[number] = std::min(usual[number], median(around));
        });
        return usual;
    }

    /// What the offsets inside a grid are where it ends: the value there of the straight line through the
    /// next few.
    [[nodiscard]] std::optional<double> carriedOn(std::size_t g, int i, int j) const {
        constexpr int maxSteps = 4;
        const int right = i == 0 ? 1 : i == columns(g) ? -1 : 0;
        const int down = j == 0 ? 1 : j == rows(g) ? -1 : 0;
        double count = 0, places = 0, squares = 0, values = 0, moments = 0;
        for (int k = 1; k <= maxSteps; ++k) {
            const auto value = offset(g, i + k * right, j + k * down);
            if (!value) continue;
            count += 1, places += k, squares += k * k, values += *value, moments += k * *value;
        }
        if (count == 0) return std::nullopt;
        if (count < 3) return values / count; // too few to know a slope from noise
        return (squares * values - places * moments) / (count * squares - places * places);
    }

    /// Along directions in which the planes do not meet, the point stays.
    static Eigen::Vector3d shortestSolution(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right) {
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

    const LatticeNormals& lattice_;
    const std::vector<ReferenceGrid>& surface_;
    std::vector<Displacement> displacements_;
    std::vector<double> weights_;
    double noise_ = 0; ///< standard deviation of the offsets
};

} // namespace

ScanReference scanReference(const QuadMesh& mesh, const Layout& layout,
                            const std::vector<ReferenceGrid>& surface, const TriangleSurface& scan,
                            const ScanOptions& options, unsigned jobs) {
    if (surface.empty()) return {};
    const LatticeNormals lattice = latticeNormals(mesh, layout, surface, jobs);
    const double edge = meanEdgeLength(mesh);
    const double step = edge / surface.front().steps;
    const ScanReach reach = options.maxDistance > 0 ? ScanReach{options.maxDistance, options.maxDistance}
                                                    : ScanReach{step, 2 * edge};
    ScanProjection projection = projectOntoScan(lattice, scan, reach, std::cos(options.maxAngle), jobs);
    Targets targets(lattice, surface, std::move(projection.displacements));
    const double negligible = step / 40; // as a difference between neighbours: no sign of an outlier
    targets.weighOutliers(negligible);
    const double coverage = targets.coverage();
    ScanReference result = targets.result();
    fillGaps(lattice, surface, Gaps::butForSharpOnes, result);
    smoothInside(result, jobs);
    targets.update(result);
    targets.carryOnToSharpEdges(scan, projection.maxDistance, step / 4);
    targets.dropSharpOutliers(negligible);
    result = targets.result();
    result.coverage = coverage;
    result.maxDistance = projection.maxDistance;
    dropFolded(lattice, surface, result);
    fillGaps(lattice, surface, Gaps::all, result);
    smoothBorders(result, jobs);
    return result;
}

} // namespace qm

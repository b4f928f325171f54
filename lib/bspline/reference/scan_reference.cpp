#include "bspline/reference/scan_reference.h"

#include "bspline/reference/lattice_normals.h"
#include "bspline/reference/scan_projection.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

double meanEdge(const QuadMesh& mesh) {
    double sum = 0;
    for (const EdgeId edge : mesh.edges())
        sum += mesh.calc_edge_length(edge);
    return mesh.n_edges() > 0 ? sum / static_cast<double>(mesh.n_edges()) : 0;
}

double median(std::vector<double>& values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

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
        const std::vector<double> residuals = residualsOfAll();
        std::vector<double> sizes;
        for (std::size_t k = 0; k < residuals.size(); ++k)
            if (weights_[k] > 0) sizes.push_back(residuals[k]);
        // The scale of a normal distribution; the biweight ends at 4.685 of it, as is usual.
        noise_ = 1.4826 * median(sizes);
        const double end = 4.685 * std::max(noise_, step);
        for (std::size_t k = 0; k < residuals.size(); ++k) {
            const double share = residuals[k] / end;
            weights_[k] *= share < 1 ? (1 - share * share) * (1 - share * share) : 0;
        }
    }

    /// Sharp points go where their sides meet, unless that is farther from the scan than they are already,
    /// beyond what noise explains: then the sides bend, and the nearest point of the scan is better.
    /// \param mostRounding  how far at most a scan's edge is from the sharp one
    void carryOnToSharpEdges(const TriangleSurface& scan, double maxDistance, double mostRounding) {
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
            const Eigen::Vector3d& normal = lattice_.oneSided[g][index(g, i, j)];
            planes.complete = planes.complete && offset.has_value();
            planes.matrix += normal * normal.transpose();
            planes.right += offset.value_or(0) * normal;
        });
        for (std::size_t k = 0; k < sharp.size(); ++k) {
            if (!all[k].complete) continue;
            const Eigen::Vector3d& from = lattice_.points[sharp[k]];
            Eigen::Vector3d moved = shortestSolution(all[k].matrix, all[k].right);
            const TriangleSurface::Nearest nearest = scan.nearest(point(from), maxDistance);
            if (!nearest.found()) continue;
            if (!scan.nearest(point(from + moved),
                              std::min(1.1 * nearest.distance, mostRounding) + 3 * noise_)
                     .found()) {
                if (nearest.onBoundary) continue;
                moved = vector(nearest.position) - from;
            }
            displacements_[sharp[k]] = moved;
            weights_[sharp[k]] = 1;
        }
    }

    [[nodiscard]] double noise() const { return noise_; }

    [[nodiscard]] ScanReference result() const {
        ScanReference result{surface_, {}};
        for (const ReferenceGrid& grid : surface_)
            result.weights.emplace_back(grid.points.size());
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            if (weights_[number] <= 0) return;
            result.grids[g].points[index(g, i, j)] = point(lattice_.points[number] + *displacements_[number]);
            result.weights[g][index(g, i, j)] = weights_[number];
        });
        const auto all = std::ranges::count(lattice_.used, true);
        const auto covered = std::ranges::count_if(weights_, [](double weight) { return weight > 0; });
        result.coverage = all > 0 ? static_cast<double>(covered) / static_cast<double>(all) : 0;
        return result;
    }

private:
    [[nodiscard]] int columns(std::size_t g) const { return surface_[g].size[0] * surface_[g].steps; }
    [[nodiscard]] int rows(std::size_t g) const { return surface_[g].size[1] * surface_[g].steps; }
    [[nodiscard]] std::size_t index(std::size_t g, int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns(g) + 1) +
               static_cast<std::size_t>(i);
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
        return displacements_[number]->dot(lattice_.oneSided[g][index(g, i, j)]);
    }

    /// How far every point is from the median of those around it: the smaller value, where it is in two
    /// grids.
    [[nodiscard]] std::vector<double> residualsOfAll() const {
        std::vector<double> residuals(weights_.size(), std::numeric_limits<double>::infinity());
        std::vector<double> around;
        forEachPoint([&](std::size_t g, int i, int j, std::size_t number) {
            const auto own = offset(g, i, j);
            if (!own) return;
            around.clear();
            for (int down = -1; down <= 1; ++down)
                for (int right = -1; right <= 1; ++right)
                    if (const auto other = offset(g, i + right, j + down)) around.push_back(*other);
            residuals[number] = std::min(residuals[number], std::abs(*own - median(around)));
        });
        return residuals;
    }

    /// What the offsets inside a grid are where it ends: the value there of the straight line through the
    /// next few.
    [[nodiscard]] std::optional<double> carriedOn(std::size_t g, int i, int j) const {
        constexpr int most = 4;
        const int right = i == 0 ? 1 : i == columns(g) ? -1 : 0;
        const int down = j == 0 ? 1 : j == rows(g) ? -1 : 0;
        double count = 0, places = 0, squares = 0, values = 0, moments = 0;
        for (int k = 1; k <= most; ++k) {
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
    const double edge = meanEdge(mesh);
    const double step = edge / surface.front().steps;
    const ScanReach reach = options.maxDistance > 0 ? ScanReach{options.maxDistance, options.maxDistance}
                                                    : ScanReach{step, 2 * edge};
    ScanProjection projection = projectOntoScan(lattice, scan, reach, std::cos(options.maxAngle), jobs);
    Targets targets(lattice, surface, std::move(projection.displacements));
    targets.weighOutliers(step / 10);
    targets.carryOnToSharpEdges(scan, projection.maxDistance, step / 4);
    ScanReference result = targets.result();
    result.maxDistance = projection.maxDistance;
    result.noise = targets.noise();
    return result;
}

} // namespace qm

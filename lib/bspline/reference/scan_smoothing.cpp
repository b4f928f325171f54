#include "bspline/reference/scan_smoothing.h"

#include "base/parallel.h"
#include "bspline/splines/eigen_point.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace qm {
namespace {

struct LinePoint {
    Point position;
    double weight = 0;
};

/// The value of the weighted cubic through points `begin` to before `end` at point k, and by how much it
/// passes on the points' noise (the root of the sum of its squared factors).
struct Smoothed {
    Point position;
    double noise = 1;
};

Smoothed cubicAt(const std::vector<LinePoint>& line, std::size_t k, std::size_t begin, std::size_t end) {
    constexpr double unknown = 1e-3; // weight of points without a target: they hold what nothing else does
    const double half = static_cast<double>(std::max(k - begin, end - 1 - k));
    const auto powers = [&](std::size_t i) {
        const double x = (static_cast<double>(i) - static_cast<double>(k)) / half;
        return Eigen::Vector4d(1, x, x * x, x * x * x);
    };
    Eigen::Matrix4d form = Eigen::Matrix4d::Zero();
    for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector4d p = powers(i);
        form += std::max(unknown, line[i].weight) * p * p.transpose();
    }
    const Eigen::Vector4d first = form.ldlt().solve(Eigen::Vector4d(1, 0, 0, 0));
    Point position(0, 0, 0);
    double squares = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const double factor = std::max(unknown, line[i].weight) * first.dot(powers(i));
        position += factor * line[i].position;
        squares += factor * factor;
    }
    return {position, std::sqrt(squares)};
}

/// \param steps  of the lattice, a mesh edge
std::vector<Point> smoothLine(const std::vector<LinePoint>& line, int steps, double noise) {
    constexpr double surprising = 2.5; // standard deviations
    const auto size = static_cast<std::ptrdiff_t>(line.size());
    std::vector<Point> result;
    for (std::ptrdiff_t k = 0; k < size; ++k) {
        Smoothed best{line[static_cast<std::size_t>(k)].position, 1};
        for (std::ptrdiff_t half = steps; half <= 4 * steps; half *= 2) {
            const std::ptrdiff_t begin = std::clamp<std::ptrdiff_t>(k - half, 0, size - 1);
            const std::ptrdiff_t end = std::min(k + half + 1, size);
            constexpr std::ptrdiff_t enough = 6;
            if (end - begin < enough) break;
            const Smoothed wider = cubicAt(line, static_cast<std::size_t>(k), static_cast<std::size_t>(begin),
                                           static_cast<std::size_t>(end));
            if ((wider.position - best.position).norm() > surprising * best.noise * noise) break;
            best = wider;
        }
        result.push_back(best.position);
    }
    return result;
}

class Smoothing {
public:
    Smoothing(ReferenceGrid& grid, const std::vector<double>& weights, double noise)
        : grid_(grid), weights_(weights),
          noise_(noise), count_{static_cast<std::size_t>(grid.size[0] * grid.steps + 1),
                                static_cast<std::size_t>(grid.size[1] * grid.steps + 1)} {}

    void run() {
        for (std::size_t i = 1; i + 1 < count_[0]; ++i)
            smooth(1, i);
        for (std::size_t j = 0; j < count_[1]; ++j)
            smooth(0, j);
        smooth(1, 0);
        smooth(1, count_[0] - 1);
    }

private:
    [[nodiscard]] std::size_t index(std::size_t direction, std::size_t line, std::size_t along) const {
        return direction == 0 ? line * count_[0] + along : along * count_[0] + line;
    }

    /// But for the ends, which lie on border lines or are corners.
    void smooth(std::size_t direction, std::size_t line) {
        std::vector<LinePoint> points;
        for (std::size_t k = 0; k < count_[direction]; ++k) {
            const std::size_t at = index(direction, line, k);
            points.push_back({grid_.points[at], weights_[at]});
        }
        const auto smoothed = smoothLine(points, grid_.steps, noise_);
        for (std::size_t k = 1; k + 1 < smoothed.size(); ++k)
            grid_.points[index(direction, line, k)] = smoothed[k];
    }

    ReferenceGrid& grid_;
    const std::vector<double>& weights_;
    double noise_;
    std::array<std::size_t, 2> count_;
};

} // namespace

void smoothTargets(ScanReference& reference, unsigned jobs) {
    if (!(reference.noise > 0)) return;
    parallelFor(reference.grids.size(), jobs, [&](std::size_t k) {
        Smoothing(reference.grids[k], reference.weights[k], reference.noise).run();
    });
}

} // namespace qm

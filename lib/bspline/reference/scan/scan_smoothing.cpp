#include "bspline/reference/scan/scan_smoothing.h"

#include "base/at.h"
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

/// The value at point k of the weighted least-squares cubic for points `begin` to before `end`, and its noise
/// in units of theirs: the root of the sum of its squared weights.
struct Smoothed {
    Point position;
    double noise = 1;
    double residual = 0; ///< of the points from the cubic: what the noise should be if it is all there is
};

Smoothed cubicAt(const std::vector<LinePoint>& line, std::size_t k, std::size_t begin, std::size_t end) {
    constexpr double unknown = 1e-3; // weight of points without a target: they hold what nothing else does
    constexpr double freedoms = 4;
    const double half = static_cast<double>(std::max(k - begin, end - 1 - k));
    const auto powers = [&](std::size_t i) {
        const double x = (static_cast<double>(i) - static_cast<double>(k)) / half;
        return Eigen::Vector4d(1, x, x * x, x * x * x);
    };
    const auto weight = [&](std::size_t i) { return std::max(unknown, line[i].weight); };
    Eigen::Matrix4d form = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 4, 3> moments = Eigen::Matrix<double, 4, 3>::Zero();
    for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector4d p = powers(i);
        form += weight(i) * p * p.transpose();
        moments += weight(i) * p * vector(line[i].position).transpose();
    }
    const auto factors = form.ldlt();
    const Eigen::Matrix<double, 4, 3> cubic = factors.solve(moments);
    const Eigen::Vector4d first = factors.solve(Eigen::Vector4d(1, 0, 0, 0));
    double passedOn = 0;
    double squares = 0;
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const Eigen::Vector4d p = powers(i);
        passedOn += std::pow(weight(i) * first.dot(p), 2);
        squares += weight(i) * (vector(line[i].position) - cubic.transpose() * p).squaredNorm();
        sum += weight(i);
    }
    const double share = 1 - freedoms / static_cast<double>(end - begin);
    return {point(Eigen::Vector3d(cubic.row(0))), std::sqrt(passedOn), std::sqrt(squares / (sum * share))};
}

/// Whether the line bends so much at a point that an edge passes there.
bool isSharpBend(const std::vector<LinePoint>& line, std::ptrdiff_t k) {
    constexpr std::ptrdiff_t reach = 2; // so that noise makes no bends
    constexpr double minCosine = 0.77;  // 40 degrees
    if (k < reach || k + reach >= std::ssize(line)) return false;
    const auto position = [&](std::ptrdiff_t i) { return line[at(i)].position; };
    const Point before = position(k) - position(k - reach);
    const Point after = position(k + reach) - position(k);
    return (before | after) < minCosine * before.norm() * after.norm();
}

/// For every point where the part of the line begins and ends in which nothing bends sharply.
std::vector<std::array<std::ptrdiff_t, 2>> smoothParts(const std::vector<LinePoint>& line) {
    std::vector<std::array<std::ptrdiff_t, 2>> parts(line.size());
    std::ptrdiff_t begin = 0;
    for (std::ptrdiff_t k = 0; k <= std::ssize(line); ++k) {
        const bool ends = k == std::ssize(line) || isSharpBend(line, k);
        if (!ends) continue;
        std::fill(parts.begin() + begin, parts.begin() + k, std::array{begin, k});
        if (k < std::ssize(line)) parts[at(k)] = {k, k + 1};
        begin = k + 1;
    }
    return parts;
}

/// \param steps  of the lattice, a mesh edge
std::vector<Point> smoothLine(const std::vector<LinePoint>& line, int steps, double noise, double grain) {
    constexpr double surprising = 2.5; // standard deviations
    constexpr double usual = 1.5;      // of a few points' residuals
    const auto parts = smoothParts(line);
    std::vector<Point> result;
    for (std::ptrdiff_t k = 0; k < std::ssize(line); ++k) {
        const auto& [first, last] = parts[at(k)];
        Smoothed best{line[at(k)].position, 1};
        for (std::ptrdiff_t half = steps; half <= std::ptrdiff_t{4} * steps; half *= 2) {
            const std::ptrdiff_t begin = std::max(k - half, first);
            const std::ptrdiff_t end = std::min(k + half + 1, last);
            constexpr std::ptrdiff_t enough = 6;
            if (end - begin < enough) break;
            const Smoothed wider = cubicAt(line, at(k), at(begin), at(end));
            const bool explained =
                half == steps ? wider.residual <= usual * noise
                              : (wider.position - best.position).norm() <= surprising * best.noise * noise;
            if (!explained) break;
            best = wider;
            best.noise = std::min(1.0, std::sqrt(grain) * best.noise);
        }
        result.push_back(best.position);
    }
    return result;
}

/// Smooths a line along u (0) or v (1), but for its ends, which lie on border lines or are corners.
void smooth(FitTarget& reference, std::size_t g, std::size_t direction, std::size_t line, double grain) {
    ReferenceGrid& grid = reference.grids[g];
    const std::size_t columns = grid.columns();
    const auto index = [&](std::size_t along) {
        return direction == 0 ? line * columns + along : along * columns + line;
    };
    std::vector<LinePoint> points;
    for (std::size_t k = 0; k < (direction == 0 ? columns : grid.rows()); ++k)
        points.push_back({grid.points[index(k)], reference.weights[g][index(k)]});
    const auto smoothed = smoothLine(points, grid.steps, reference.noise, grain);
    for (std::size_t k = 1; k + 1 < smoothed.size(); ++k)
        grid.points[index(k)] = smoothed[k];
}

/// Of lines along u (0) or v (1).
std::size_t lines(const ReferenceGrid& grid, std::size_t direction) {
    return direction == 0 ? grid.rows() : grid.columns();
}

} // namespace

void smoothInside(FitTarget& reference, double grain, unsigned jobs) {
    if (!(reference.noise > 0)) return;
    parallelFor(reference.grids.size(), jobs, [&](std::size_t g) {
        for (const std::size_t direction : {1U, 0U})
            for (std::size_t line = 1; line + 1 < lines(reference.grids[g], direction); ++line)
                smooth(reference, g, direction, line, grain);
    });
}

void smoothBorders(FitTarget& reference, double grain, unsigned jobs) {
    if (!(reference.noise > 0)) return;
    parallelFor(reference.grids.size(), jobs, [&](std::size_t g) {
        for (const std::size_t direction : {0U, 1U}) {
            smooth(reference, g, direction, 0, grain);
            smooth(reference, g, direction, lines(reference.grids[g], direction) - 1, grain);
        }
    });
}

} // namespace qm

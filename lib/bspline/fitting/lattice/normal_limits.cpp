#include "bspline/fitting/lattice/normal_limits.h"

#include "bspline/splines/bezier_extraction.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

/// Radians; smaller waves are not seen in reflections.
constexpr double minLimit = 0.1 / 180 * std::numbers::pi;
/// Factor of the unevenness with which the normal turns: closer limits would follow noise.
constexpr double share = 2;

/// The difference between the turns into and out of a direction, in radians.
double unevenness(const Point& before, const Point& here, const Point& after) {
    const Point change = before - 2.0 * here + after;
    return (change - here * (change | here)).norm();
}

} // namespace

NormalLimits::NormalLimits(const ReferenceGrid& grid) : columns_(static_cast<std::size_t>(grid.size[0]) + 1) {
    std::vector<Point> normals;
    for (const SurfacePoint& point : grid.evaluateLattice(gridLines(grid.size[0]), gridLines(grid.size[1])))
        normals.push_back(unitNormal(point.du, point.dv).value_or(Point(0, 0, 0)));
    const std::array<std::size_t, 2> stride{1, columns_};
    for (std::size_t d = 0; d < 2; ++d) {
        limits_[d].assign(normals.size(), minLimit);
        const auto last = static_cast<std::size_t>(grid.size[d]);
        for (std::size_t line = 0; line < normals.size() / (last + 1); ++line)
            for (std::size_t k = 1; k < last; ++k) {
                const std::size_t here = line * stride[1 - d] + k * stride[d];
                const std::array near{here - stride[d], here, here + stride[d]};
                const double uneven = unevenness(normals[near[0]], normals[near[1]], normals[near[2]]);
                for (const std::size_t vertex : near)
                    limits_[d][vertex] = std::max(limits_[d][vertex], share * uneven);
            }
    }
}

double NormalLimits::at(std::size_t direction, const std::array<double, 2>& parameters) const {
    const auto nearest = [&](std::size_t d) { return static_cast<std::size_t>(std::lround(parameters[d])); };
    return limits_[direction][nearest(1) * columns_ + nearest(0)];
}

} // namespace qm

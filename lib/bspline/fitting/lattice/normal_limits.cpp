#include "bspline/fitting/lattice/normal_limits.h"

#include "base/at.h"
#include "base/infinity.h"
#include "bspline/splines/bezier_extraction.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double degree = std::numbers::pi / 180;
/// Smaller waves are not seen in reflections.
constexpr double minOfNormals = 0.1 * degree;
/// At a crease, what the surface beside it loses across comes in addition.
constexpr double minOfCreases = 0.08 * degree;
/// Factor of the unevenness with which the normal turns: closer limits would follow noise.
constexpr double share = 2;

/// The difference between the turns into and out of a direction, in radians.
double unevenness(const Point& before, const Point& here, const Point& after) {
    const Point change = before - 2.0 * here + after;
    return (change - here * (change | here)).norm();
}

/// By vertex, for lines along u (0) or v (1), along which these directions turn.
std::vector<double> limitsOf(const std::vector<Point>& directions, const std::array<std::size_t, 2>& size,
                             std::size_t along, double min) {
    const std::array<std::size_t, 2> stride{1, size[0] + 1};
    std::vector<double> limits(directions.size(), min);
    for (std::size_t line = 0; line <= size[1 - along]; ++line)
        for (std::size_t k = 1; k < size[along]; ++k) {
            const std::size_t here = line * stride[1 - along] + k * stride[along];
            const std::array near{here - stride[along], here, here + stride[along]};
            const double uneven = unevenness(directions[near[0]], directions[near[1]], directions[near[2]]);
            for (const std::size_t vertex : near)
                limits[vertex] = std::max(limits[vertex], share * uneven);
        }
    return limits;
}

} // namespace

NormalLimits::NormalLimits(const ReferenceGrid& grid) : size_{qm::at(grid.size[0]), qm::at(grid.size[1])} {
    std::vector<Point> normals;
    std::array<std::vector<Point>, 2> tangents;
    for (const SurfacePoint& point : grid.evaluateLattice(gridLines(grid.size[0]), gridLines(grid.size[1]))) {
        normals.push_back(point.normal());
        tangents[0].push_back(unit(point.du));
        tangents[1].push_back(unit(point.dv));
    }
    for (std::size_t direction = 0; direction < 2; ++direction) {
        ofNormals_[direction] = limitsOf(normals, size_, direction, minOfNormals);
        ofCreases_[direction] = limitsOf(tangents[direction], size_, direction, minOfCreases);
    }
}

std::size_t NormalLimits::vertexAt(const std::array<double, 2>& parameters) const {
    const auto nearest = [&](std::size_t d) { return static_cast<std::size_t>(std::lround(parameters[d])); };
    return nearest(1) * (size_[0] + 1) + nearest(0);
}

double NormalLimits::at(std::size_t direction, const std::array<double, 2>& parameters) const {
    return ofNormals_[direction][vertexAt(parameters)];
}

double NormalLimits::onCrease(std::size_t direction, const std::array<double, 2>& parameters) const {
    return ofCreases_[direction][vertexAt(parameters)];
}

double NormalLimits::at(const FitLattice& lattice, std::size_t direction, std::size_t line,
                        std::size_t k) const {
    const std::size_t point = lattice.onLine(direction, line, k);
    const bool isSide = line == 0 || line + 1 == lattice.targets.parameters[1 - direction].size();
    switch (lattice.freedom[point]) {
    case Freedom::surface:
        return at(direction, lattice.parametersAt(point));
    case Freedom::crease:
        return isSide ? onCrease(direction, lattice.parametersAt(point)) : infinity;
    default:
        return infinity;
    }
}

} // namespace qm

#include "bspline/reference/reference_grid.h"

#include "base/at.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// A quad of one direction, and the Lagrange polynomials of its lattice points at a parameter.
struct Weights {
    std::size_t first = 0; ///< of its lattice points
    std::size_t count = 0;
    std::array<double, maxSteps + 1> value{};
    std::array<double, maxSteps + 1> derivative{};
};

Weights lagrange(int quads, int steps, double parameter) {
    const int quad = static_cast<int>(std::clamp(std::floor(parameter), 0.0, quads - 1.0));
    const double x = (parameter - quad) * steps;
    Weights weights;
    weights.first = at(quad) * at(steps);
    weights.count = at(steps) + 1;
    for (std::size_t k = 0; k < weights.count; ++k) {
        weights.value[k] = 1;
        for (std::size_t m = 0; m < weights.count; ++m) {
            if (m == k) continue;
            const double distance = static_cast<double>(k) - static_cast<double>(m);
            const double factor = (x - static_cast<double>(m)) / distance;
            weights.derivative[k] = weights.derivative[k] * factor + weights.value[k] * (steps / distance);
            weights.value[k] *= factor;
        }
    }
    return weights;
}

SurfacePoint combine(const ReferenceGrid& grid, const Weights& columns, const Weights& rows) {
    const std::size_t width = at(grid.size[0]) * at(grid.steps) + 1;
    SurfacePoint result;
    for (std::size_t j = 0; j < rows.count; ++j) {
        Point position{0, 0, 0};
        Point du{0, 0, 0};
        const Point* point = grid.points.data() + (rows.first + j) * width + columns.first;
        for (std::size_t i = 0; i < columns.count; ++i, ++point) {
            position += columns.value[i] * *point;
            du += columns.derivative[i] * *point;
        }
        result.position += rows.value[j] * position;
        result.du += rows.value[j] * du;
        result.dv += rows.derivative[j] * position;
    }
    return result;
}

} // namespace

SurfacePoint ReferenceGrid::evaluate(double u, double v) const {
    return combine(*this, lagrange(size[0], steps, u), lagrange(size[1], steps, v));
}

std::vector<SurfacePoint> ReferenceGrid::evaluateLattice(const std::vector<double>& us,
                                                         const std::vector<double>& vs) const {
    std::vector<Weights> columns;
    columns.reserve(us.size());
    for (const double u : us)
        columns.push_back(lagrange(size[0], steps, u));
    std::vector<SurfacePoint> result;
    result.reserve(us.size() * vs.size());
    for (const double v : vs) {
        const Weights row = lagrange(size[1], steps, v);
        for (const Weights& column : columns)
            result.push_back(combine(*this, column, row));
    }
    return result;
}

} // namespace qm

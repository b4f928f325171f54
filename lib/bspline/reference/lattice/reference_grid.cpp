#include "bspline/reference/lattice/reference_grid.h"

#include "bspline/splines/interpolate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace qm {
namespace {

/// A quad of one direction, and what its lattice points count at a parameter.
struct Weights {
    std::size_t first = 0; ///< of its lattice points
    LagrangeWeights jets{};
};

Weights weightsAt(int quads, int steps, double parameter) {
    const double quad = std::clamp(std::floor(parameter), 0.0, quads - 1.0);
    return {static_cast<std::size_t>(quad) * at(steps), lagrange(steps, parameter - quad)};
}

SurfacePoint combine(const ReferenceGrid& grid, const Weights& columns, const Weights& rows) {
    const std::size_t count = at(grid.steps) + 1;
    SurfacePoint result;
    for (std::size_t j = 0; j < count; ++j) {
        Point position{0, 0, 0};
        Point du{0, 0, 0};
        const Point* point = grid.points.data() + (rows.first + j) * grid.columns() + columns.first;
        for (std::size_t i = 0; i < count; ++i, ++point) {
            position += columns.jets[i][0] * *point;
            du += columns.jets[i][1] * *point;
        }
        result.position += rows.jets[j][0] * position;
        result.du += rows.jets[j][0] * du;
        result.dv += rows.jets[j][1] * position;
    }
    return result;
}

} // namespace

SurfacePoint ReferenceGrid::evaluate(double u, double v) const {
    return combine(*this, weightsAt(size[0], steps, u), weightsAt(size[1], steps, v));
}

std::vector<SurfacePoint> ReferenceGrid::evaluateLattice(const std::vector<double>& us,
                                                         const std::vector<double>& vs) const {
    std::vector<Weights> columns;
    columns.reserve(us.size());
    for (const double u : us)
        columns.push_back(weightsAt(size[0], steps, u));
    std::vector<SurfacePoint> result;
    result.reserve(us.size() * vs.size());
    for (const double v : vs) {
        const Weights row = weightsAt(size[1], steps, v);
        for (const Weights& column : columns)
            result.push_back(combine(*this, column, row));
    }
    return result;
}

std::vector<ReferenceGrid> facetGrids(const QuadMesh& mesh, const Layout& layout) {
    std::vector<ReferenceGrid> grids;
    for (const Segment& segment : layout.segments)
        grids.push_back({segment.size, 1, pointGrid(mesh, segment)});
    return grids;
}

} // namespace qm

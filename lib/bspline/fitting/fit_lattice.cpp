#include "bspline/fitting/fit_lattice.h"

#include "bspline/network/borders.h"
#include "bspline/splines/evaluate.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

std::vector<double> parametersOf(int size, int steps) {
    std::vector<double> parameters;
    for (int k = 0; k <= size * steps; ++k)
        parameters.push_back(static_cast<double>(k) / steps);
    return parameters;
}

Point unit(const Point& vector) {
    const double length = vector.norm();
    return length > 0 ? vector / length : Point(0, 0, 0);
}

/// Derivatives of the reference by central differences, one-sided at its borders.
void measureAxes(const ReferenceGrid& grid, FitLattice& lattice) {
    const std::size_t columns = lattice.columns();
    const std::size_t rows = lattice.rows();
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t before = i > 0 ? i - 1 : i;
            const std::size_t after = std::min(i + 1, columns - 1);
            const std::size_t below = j > 0 ? j - 1 : j;
            const std::size_t above = std::min(j + 1, rows - 1);
            const Point du = grid.points[j * columns + after] - grid.points[j * columns + before];
            const Point dv = grid.points[above * columns + i] - grid.points[below * columns + i];
            const double scale = static_cast<double>(grid.steps * grid.steps) /
                                 static_cast<double>((after - before) * (above - below));
            lattice.axes.push_back(unitNormal(du, dv));
            lattice.jacobian.push_back((du % dv).norm() * scale);
        }
}

/// Marks the points of a side that lie on creases, and the corners where no smooth curve passes.
void markSide(const QuadMesh& mesh, const Segment& segment, int side, const SmoothNetwork& network,
              const ReferenceGrid& grid, FitLattice& lattice) {
    const auto& vertices = segment.sides[static_cast<std::size_t>(side)];
    const int length = static_cast<int>(vertices.size()) - 1;
    const auto index = [&](int step) {
        const auto at = parametersOnSide(segment.size, side, static_cast<double>(step) / lattice.steps);
        const auto i = static_cast<std::size_t>(std::lround(at[0] * lattice.steps));
        const auto j = static_cast<std::size_t>(std::lround(at[1] * lattice.steps));
        return j * lattice.columns() + i;
    };
    std::vector<bool> isCrease;
    for (int k = 0; k < length; ++k) {
        const auto from = static_cast<std::size_t>(k);
        const EdgeId edge = mesh.edge_handle(mesh.find_halfedge(vertices[from], vertices[from + 1]));
        isCrease.push_back(network.marks.isCrease[static_cast<std::size_t>(edge.idx())]);
    }
    const int last = length * lattice.steps;
    for (int step = 0; step <= last; ++step) {
        const bool before = isCrease[static_cast<std::size_t>(std::max(step - 1, 0) / lattice.steps)];
        const bool after = isCrease[static_cast<std::size_t>(std::min(step / lattice.steps, length - 1))];
        if (!before && !after) continue;
        const std::size_t point = index(step);
        const bool isEnd = step == 0 || step == last;
        const VertexId vertex = step == 0 ? vertices.front() : vertices.back();
        if (isEnd && network.rules[static_cast<std::size_t>(vertex.idx())].kind == VertexRule::Kind::corner)
            lattice.freedom[point] = Freedom::corner;
        if (isEnd) continue;
        lattice.freedom[point] = Freedom::crease;
        lattice.axes[point] = unit(grid.points[index(step + 1)] - grid.points[index(step - 1)]);
    }
}

} // namespace

std::vector<FitLattice> fitLattices(const QuadMesh& mesh, const Layout& layout, const SmoothNetwork& network,
                                    const std::vector<ReferenceGrid>& reference) {
    std::vector<FitLattice> lattices(reference.size());
    for (std::size_t k = 0; k < reference.size(); ++k) {
        const ReferenceGrid& grid = reference[k];
        FitLattice& lattice = lattices[k];
        lattice.steps = grid.steps;
        lattice.targets.parameters = {parametersOf(grid.size[0], grid.steps),
                                      parametersOf(grid.size[1], grid.steps)};
        lattice.targets.points = grid.points;
        lattice.targets.weights.assign(grid.points.size(), 1.0 / (grid.steps * grid.steps));
        lattice.freedom.assign(grid.points.size(), Freedom::surface);
        measureAxes(grid, lattice);
        for (int side = 0; side < 4; ++side)
            markSide(mesh, layout.segments[k], side, network, grid, lattice);
    }
    return lattices;
}

double distance(const FitLattice& lattice, std::size_t point, const Point& offset) {
    const Point& axis = lattice.axes[point];
    switch (lattice.freedom[point]) {
    case Freedom::surface:
        return axis.sqrnorm() > 0 ? std::abs(offset | axis) : offset.norm();
    case Freedom::crease:
        return (offset - axis * (offset | axis)).norm();
    default:
        return offset.norm();
    }
}

std::vector<double> errors(const FitLattice& lattice, const Patch& patch, double tolerance) {
    constexpr double minJacobian = 0.1; // of the reference's
    const auto points = evaluateLattice(patch, lattice.targets.parameters[0], lattice.targets.parameters[1]);
    std::vector<double> result(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Point offset = points[k].position - lattice.targets.points[k];
        // Where the surface has slid along a bend, the mean of both normals tells how far it is.
        const Point mean = lattice.axes[k] + unitNormal(points[k].du, points[k].dv);
        const bool canSlide = lattice.freedom[k] == Freedom::surface && mean.sqrnorm() > 1;
        result[k] =
            (canSlide ? std::abs(offset | mean) / mean.norm() : distance(lattice, k, offset)) / tolerance;
        const bool isFolded =
            lattice.freedom[k] == Freedom::surface &&
            ((points[k].du % points[k].dv) | lattice.axes[k]) < minJacobian * lattice.jacobian[k];
        if (isFolded) result[k] = std::max(result[k], 2.0);
    }
    return result;
}

} // namespace qm

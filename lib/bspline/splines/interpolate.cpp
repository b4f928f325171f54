#include "bspline/splines/interpolate.h"

#include "base/at.h"
#include "base/parallel.h"

#include <numeric>

namespace qm {
namespace {

std::vector<double> uniformKnots(std::size_t intervals) {
    std::vector<double> knots(intervals + 7);
    std::iota(knots.begin(), knots.end(), -3.0);
    return knots;
}

/// Eliminating the free ends C_0 = C_1 and C_last-1 = C_last leaves a symmetric tridiagonal matrix with the
/// diagonal 5 4 ... 4 5 and ones beside it. These are the reciprocal pivots of its elimination.
std::vector<double> reciprocalPivots(std::size_t size) {
    std::vector<double> reciprocal(size);
    double previous = 0;
    for (std::size_t k = 0; k < size; ++k) {
        const double diagonal = k == 0 || k + 1 == size ? 5 : 4;
        previous = reciprocal[k] = 1 / (diagonal - previous);
    }
    return reciprocal;
}

/// Where the entries of a line of points lie in an array: the k-th at begin + k * step.
struct Line {
    std::size_t begin = 0;
    std::size_t step = 1;
};

/// Control points of the uniform cubic B-spline through a line of points.
void blend(std::span<const Point> data, Line from, std::span<const double> reciprocal,
           std::vector<Point>& control, Line to) {
    const std::size_t size = reciprocal.size();
    const auto unknown = [&](std::size_t k) -> Point& { return control[to.begin + (k + 1) * to.step]; };

    Point previous{0, 0, 0};
    for (std::size_t k = 0; k < size; ++k) {
        previous = (6.0 * data[from.begin + k * from.step] - previous) * reciprocal[k];
        unknown(k) = previous;
    }
    for (std::size_t k = size - 1; k-- > 0;)
        unknown(k) -= unknown(k + 1) * reciprocal[k];
    control[to.begin] = unknown(0);
    control[to.begin + (size + 1) * to.step] = unknown(size - 1);
}

} // namespace

Patch interpolate(std::span<const Point> grid, std::array<int, 2> size) {
    const std::size_t m = at(size[0]);
    const std::size_t n = at(size[1]);
    Patch patch;
    patch.count = {size[0] + 3, size[1] + 3};
    patch.knots = {uniformKnots(m), uniformKnots(n)};

    const auto pivotsU = reciprocalPivots(m + 1);
    std::vector<Point> rows((m + 3) * (n + 1));
    for (std::size_t j = 0; j <= n; ++j)
        blend(grid, {j * (m + 1), 1}, pivotsU, rows, {j * (m + 3), 1});

    const auto pivotsV = reciprocalPivots(n + 1);
    patch.controlPoints.resize((m + 3) * (n + 3));
    for (std::size_t i = 0; i < m + 3; ++i)
        blend(rows, {i, m + 3}, pivotsV, patch.controlPoints, {i, m + 3});
    return patch;
}

std::vector<Point> pointGrid(const QuadMesh& mesh, const Segment& segment) {
    std::vector<Point> points;
    for (const VertexId vertex : vertexGrid(mesh, segment))
        points.push_back(mesh.point(vertex));
    return points;
}

std::vector<Patch> interpolateSegments(const QuadMesh& mesh, const Layout& layout, unsigned jobs) {
    std::vector<Patch> patches(layout.segments.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        patches[k] = interpolate(pointGrid(mesh, layout.segments[k]), layout.segments[k].size);
        patches[k].segment = SegmentId(k);
    });
    return patches;
}

} // namespace qm

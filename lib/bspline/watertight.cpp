#include "bspline/watertight.h"

#include "base/parallel.h"
#include "bspline/interpolate.h"
#include "bspline/patch_frame.h"

namespace qm {
namespace {

std::vector<double> knotsOf(const std::array<SplineCurve, 2>& curves,
                            const std::array<SplineCurve, 2>& across) {
    return commonKnots(commonKnots(curves[0].knots, curves[1].knots),
                       commonKnots(across[0].knots, across[1].knots));
}

std::vector<Point> atIntegers(const SplineCurve& curve, int length) {
    std::vector<Point> points;
    for (int k = 0; k <= length; ++k)
        points.push_back(evaluate(curve, k));
    return points;
}

/// Every row of points as control points over the patch's knots in u; the border rows are the frame's curves.
std::vector<std::vector<Point>> splineRows(std::span<const Point> grid, const std::array<int, 2>& size,
                                           const PatchFrame& frame, const std::vector<double>& knots) {
    const auto width = static_cast<std::size_t>(size[0]) + 1;
    const auto height = static_cast<std::size_t>(size[1]) + 1;
    const auto start = atIntegers(frame.acrossV[0], size[1]);
    const auto end = atIntegers(frame.acrossV[1], size[1]);
    std::vector<std::vector<Point>> rows(height);
    for (std::size_t j = 0; j < height; ++j) {
        const bool border = j == 0 || j + 1 == height;
        const SplineCurve row = border ? frame.alongU[j == 0 ? 0 : 1]
                                       : interpolateClamped(grid.subspan(j * width, width), start[j], end[j]);
        rows[j] = withKnots(row, knots).points;
    }
    return rows;
}

void setColumn(Patch& patch, std::size_t i, const std::vector<Point>& points) {
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    for (std::size_t j = 0; j < points.size(); ++j)
        patch.controlPoints[j * columns + i] = points[j];
}

} // namespace

Patch interpolateBetween(std::span<const Point> grid, const std::array<int, 2>& size,
                         const std::array<SideCurves, 4>& sides) {
    const PatchFrame frame = patchFrame(sides);
    Patch patch = emptyPatch(knotsOf(frame.alongU, frame.acrossU), knotsOf(frame.alongV, frame.acrossV));
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    const auto rows = splineRows(grid, size, frame, patch.knots[0]);
    const auto slopesAtStart = withKnots(frame.acrossU[0], patch.knots[0]).points;
    const auto slopesAtEnd = withKnots(frame.acrossU[1], patch.knots[0]).points;

    std::vector<Point> values(rows.size());
    for (std::size_t i = 2; i + 2 < columns; ++i) {
        for (std::size_t j = 0; j < rows.size(); ++j)
            values[j] = rows[j][i];
        const SplineCurve column = interpolateClamped(values, slopesAtStart[i], slopesAtEnd[i]);
        setColumn(patch, i, withKnots(column, patch.knots[1]).points);
    }

    // The two outer columns on either side are the border curve, and it moved along the derivative across.
    for (std::size_t end = 0; end < 2; ++end) {
        const double step = (end == 0 ? 1 : -1) / 3.0; // the first and the last interval have length one
        const auto border = withKnots(frame.alongV[end], patch.knots[1]).points;
        const auto across = withKnots(frame.acrossV[end], patch.knots[1]).points;
        std::vector<Point> beside;
        for (std::size_t j = 0; j < border.size(); ++j)
            beside.push_back(border[j] + step * across[j]);
        setColumn(patch, end == 0 ? 0 : columns - 1, border);
        setColumn(patch, end == 0 ? 1 : columns - 2, beside);
    }
    setBorder(patch, frame);
    return patch;
}

std::vector<Patch> interpolateWatertight(const QuadMesh& mesh, const Layout& layout,
                                         const std::vector<double>& dihedralAngles, double rho,
                                         unsigned jobs) {
    const Chains chains(mesh, layout);
    const LineDerivatives lines(mesh, dihedralAngles, rho);
    const CurveNetwork network(mesh, chains, lines);
    std::vector<Patch> patches(layout.segments.size());
    parallelFor(patches.size(), jobs, [&](std::size_t k) {
        const Segment& segment = layout.segments[k];
        std::array<SideCurves, 4> sides;
        for (int side = 0; side < 4; ++side)
            sides[static_cast<std::size_t>(side)] = network.side(k, side);
        patches[k] = interpolateBetween(pointGrid(mesh, segment), segment.size, sides);
        patches[k].segment = SegmentId(k);
    });
    return patches;
}

} // namespace qm

#include "bspline/splines/clamped_patch.h"

#include "base/at.h"
#include "layout/sides.h"

#include <algorithm>

namespace qm {
namespace {

std::vector<double> clampedKnots(const std::vector<double>& knots, int degree) {
    if (degree < 3) return knots;
    std::vector<double> result = knots;
    const std::size_t last = knots.size() - 4;
    std::fill_n(result.begin(), 3, knots[3]);
    std::fill(result.begin() + static_cast<std::ptrdiff_t>(last), result.end(), knots[last]);
    return result;
}

} // namespace

Patch clamped(const Patch& patch) {
    const std::array<std::vector<double>, 2> knots = {clampedKnots(patch.knots[0], patch.degree[0]),
                                                      clampedKnots(patch.knots[1], patch.degree[1])};
    if (knots == patch.knots) return patch;
    Patch result = patch;
    result.knots = knots;
    const std::size_t columns = at(patch.count[0]);
    const std::size_t rows = at(patch.count[1]);
    SplineCurve line;
    line.knots = patch.knots[0];
    for (std::size_t j = 0; j < rows && knots[0] != patch.knots[0]; ++j) {
        const auto row = result.controlPoints.begin() + static_cast<std::ptrdiff_t>(j * columns);
        line.points.assign(row, row + static_cast<std::ptrdiff_t>(columns));
        std::ranges::copy(withKnots(line, knots[0]).points, row);
    }
    line.knots = patch.knots[1];
    line.points.resize(rows);
    for (std::size_t i = 0; i < columns && knots[1] != patch.knots[1]; ++i) {
        for (std::size_t j = 0; j < rows; ++j)
            line.points[j] = result.controlPoints[j * columns + i];
        const SplineCurve column = withKnots(line, knots[1]);
        for (std::size_t j = 0; j < rows; ++j)
            result.controlPoints[j * columns + i] = column.points[j];
    }
    return result;
}

std::vector<SplineCurve> rowCurves(const Patch& clampedPatch) {
    std::vector<SplineCurve> curves;
    const auto columns = static_cast<std::ptrdiff_t>(clampedPatch.count[0]);
    const auto& points = clampedPatch.controlPoints;
    for (auto row = points.begin(); row != points.end(); row += columns)
        if (clampedPatch.degree[0] == 3)
            curves.push_back({clampedPatch.knots[0], {row, row + columns}});
        else
            curves.push_back(bezier({row, row + columns}, clampedPatch.knots[0].back()));
    return curves;
}

SplineCurve borderCurve(const Patch& clampedPatch, int side) {
    const std::array<std::size_t, 2> count{at(clampedPatch.count[0]), at(clampedPatch.count[1])};
    const std::size_t along = directionAlong(side);
    SplineCurve curve;
    curve.knots = clampedPatch.knots[along];
    for (std::size_t k = 0; k < count[along]; ++k)
        curve.points.push_back(clampedPatch.controlPoints[pointOnSide(count, side, k)]);
    if (clampedPatch.degree[along] < 3) curve = bezier(curve.points, curve.knots.back());
    return isReversed(side) ? reversed(curve) : curve;
}

} // namespace qm

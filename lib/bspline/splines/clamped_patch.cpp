#include "bspline/splines/clamped_patch.h"

#include "base/at.h"
#include "layout/sides.h"

#include <algorithm>
#include <utility>

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

Patch clampedAlongU(const Patch& patch) {
    const std::vector<double> knots = clampedKnots(patch.knots[0], patch.degree[0]);
    if (knots == patch.knots[0]) return patch;
    Patch result = patch;
    result.knots[0] = knots;
    auto next = result.controlPoints.begin();
    for (const SplineCurve& row : rowCurves(patch))
        next = std::ranges::copy(withKnots(row, knots).points, next).out;
    return result;
}

} // namespace

Patch clamped(const Patch& patch) {
    return transposed(clampedAlongU(transposed(clampedAlongU(patch))));
}

Patch transposed(const Patch& patch) {
    Patch result = patch;
    std::swap(result.degree[0], result.degree[1]);
    std::swap(result.knots[0], result.knots[1]);
    std::swap(result.count[0], result.count[1]);
    const std::size_t columns = at(patch.count[0]);
    const std::size_t rows = at(patch.count[1]);
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i)
            result.controlPoints[i * rows + j] = patch.controlPoints[j * columns + i];
    return result;
}

std::vector<SplineCurve> rowCurves(const Patch& patch) {
    std::vector<SplineCurve> curves;
    const auto columns = static_cast<std::ptrdiff_t>(patch.count[0]);
    const auto& points = patch.controlPoints;
    for (auto row = points.begin(); row != points.end(); row += columns)
        if (patch.degree[0] == 3)
            curves.push_back({patch.knots[0], {row, row + columns}});
        else
            curves.push_back(bezier({row, row + columns}, patch.knots[0].back()));
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

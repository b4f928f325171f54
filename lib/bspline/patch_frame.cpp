#include "bspline/patch_frame.h"

#include "bspline/basis.h"

#include <utility>

namespace qm {

PatchFrame patchFrame(const std::array<SideCurves, 4>& sides) {
    PatchFrame frame;
    frame.alongU = {sides[0].position, reversed(sides[2].position)};
    frame.alongV = {reversed(sides[3].position), sides[1].position};
    frame.acrossU = {sides[0].inwards, scaled(reversed(sides[2].inwards), -1)};
    frame.acrossV = {reversed(sides[3].inwards), scaled(sides[1].inwards, -1)};
    return frame;
}

Patch emptyPatch(std::vector<double> knotsU, std::vector<double> knotsV) {
    Patch patch;
    patch.degree = {clampedDegree(knotsU), clampedDegree(knotsV)};
    patch.count = {static_cast<int>(knotsU.size()) - patch.degree[0] - 1,
                   static_cast<int>(knotsV.size()) - patch.degree[1] - 1};
    patch.knots = {std::move(knotsU), std::move(knotsV)};
    patch.controlPoints.assign(
        static_cast<std::size_t>(patch.count[0]) * static_cast<std::size_t>(patch.count[1]), Point(0, 0, 0));
    return patch;
}

void setBorder(Patch& patch, const PatchFrame& frame) {
    const auto columns = static_cast<std::size_t>(patch.count[0]);
    const auto rows = static_cast<std::size_t>(patch.count[1]);
    const auto pointsOf = [&](const SplineCurve& curve, std::size_t d) {
        return patch.degree[d] < 3 ? lowered(curve, patch.degree[d])
                                   : withKnots(curve, patch.knots[d]).points;
    };
    for (std::size_t end = 0; end < 2; ++end) {
        const auto alongU = pointsOf(frame.alongU[end], 0);
        for (std::size_t i = 0; i < columns; ++i)
            patch.controlPoints[end * (rows - 1) * columns + i] = alongU[i];
        const auto alongV = pointsOf(frame.alongV[end], 1);
        for (std::size_t j = 0; j < rows; ++j)
            patch.controlPoints[j * columns + end * (columns - 1)] = alongV[j];
    }
}

} // namespace qm

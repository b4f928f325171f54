#include "base/at.h"
#include "bspline/splines/clamped_patch.h"
#include "export/faces/face_patches.h"

#include <algorithm>
#include <cstddef>
#include <set>

namespace qm {
namespace {

std::size_t distinct(const std::vector<double>& knots) {
    return std::set(knots.begin(), knots.end()).size();
}

} // namespace

Segment quarterTurned(const Segment& segment) {
    Segment result;
    const auto [a, b] = segment.size;
    result.size = {b, a};
    for (std::size_t k = 0; k < 4; ++k) {
        result.sides[k] = segment.sides[(k + 1) % 4];
        result.corners[k] = segment.corners[(k + 1) % 4];
    }
    for (int j = 0; j < a; ++j)
        for (int i = 0; i < b; ++i)
            result.faces.push_back(segment.faces[at(i * a + a - 1 - j)]);
    return result;
}

Patch quarterTurned(const Patch& patch) {
    Patch result = transposed(patch); // and then its rows in the opposite order
    std::vector<double>& knots = result.knots[1];
    std::ranges::reverse(knots);
    for (double& knot : knots)
        knot = patch.knots[0].back() - knot;
    std::ranges::reverse(result.controlPoints);
    for (auto row = result.controlPoints.begin(); row != result.controlPoints.end(); row += result.count[0])
        std::reverse(row, row + result.count[0]);
    return result;
}

FacePatches withMoreKnotsAlongV(FacePatches faces) {
    for (std::size_t f = 0; f < faces.patches.size(); ++f) {
        const auto& knots = faces.patches[f].knots;
        if (distinct(knots[0]) <= distinct(knots[1])) continue;
        faces.patches[f] = quarterTurned(faces.patches[f]);
        faces.layout.segments[f] = quarterTurned(faces.layout.segments[f]);
    }
    return faces;
}

} // namespace qm

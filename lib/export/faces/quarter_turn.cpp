#include "base/at.h"
#include "export/faces/face_patches.h"

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
    Patch result = patch;
    const auto [columns, rows] = patch.count;
    result.count = {rows, columns};
    result.degree = {patch.degree[1], patch.degree[0]};
    result.knots[0] = patch.knots[1];
    result.knots[1].assign(patch.knots[0].rbegin(), patch.knots[0].rend());
    for (double& knot : result.knots[1])
        knot = patch.knots[0].back() - knot;
    result.controlPoints.clear();
    for (int j = 0; j < columns; ++j)
        for (int i = 0; i < rows; ++i)
            result.controlPoints.push_back(patch.controlPoints[at(i * columns + columns - 1 - j)]);
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

#include "check/surfaces/folds.h"

#include "base/at.h"

#include <cmath>

namespace qm::check {

namespace {

/// Whether the cosine of the angle between two vectors is less than this.
bool isTurned(const Vector& a, const Vector& b, double cosine) {
    return dot(a, b) < cosine * std::sqrt(dot(a, a) * dot(b, b));
}

/// Whether a quad is almost a triangle, with a corner in the middle of a side.
bool hasFlatCorner(const BilinearQuad& quad) {
    constexpr double flat = -0.966; // cosine of 165 degrees
    for (std::size_t k = 0; k < 4; ++k)
        if (isTurned(minus(quad.corners[(k + 1) % 4], quad.corners[k]),
                     minus(quad.corners[(k + 3) % 4], quad.corners[k]), flat))
            return true;
    return false;
}

} // namespace

const SurfacePoint& QuadSamples::at(int i, int j) const {
    return points[qm::at(j) * width + first + qm::at(i)];
}

bool isFolded(const BilinearQuad& quad, const QuadSamples& samples) {
    if (hasFlatCorner(quad)) return false;
    const auto normal = [&](int i, int j) {
        const SurfacePoint& there = samples.at(i, j);
        return cross(there.alongU, there.alongV);
    };
    // A smooth surface through the corners may itself be turned against the quad by 60 degrees.
    constexpr double away = -0.87;
    if (isTurned(normal(samplesPerEdge / 2, samplesPerEdge / 2), quad.normal(), away)) return true;
    constexpr double over = -0.5;
    const auto isCorner = [](int i, int j) { return i % samplesPerEdge == 0 && j % samplesPerEdge == 0; };
    const auto turns = [&](int i, int j, int right, int down) {
        return !isCorner(i, j) && !isCorner(i + right, j + down) &&
               isTurned(normal(i, j), normal(i + right, j + down), over);
    };
    for (int j = 0; j < samplesPerEdge; ++j)
        for (int i = 0; i < samplesPerEdge; ++i)
            if (turns(i, j, 1, 0) || turns(i, j, 0, 1)) return true;
    return false;
}

bool liesAgainstNeighbour(const CheckedMesh& mesh, const Neighbourhoods& around, const Angles& angles,
                          int face) {
    constexpr double sharpest = 1.75; // 100 degrees: edges of parts may be as sharp
    const auto& corners = mesh.quads[at(face)];
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const int step = around.stepBetween(corners[k], corners[(k + 1) % corners.size()]);
        if (angles.angle[at(around.edge(step))] > sharpest) return true;
    }
    return false;
}

} // namespace qm::check

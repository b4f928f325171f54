#include "export/faces/face_patches.h"

#include "base/at.h"
#include "base/error.h"
#include "bspline/splines/basis.h"
#include "bspline/splines/clamped_patch.h"
#include "layout/sides.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace qm {
namespace {

/// Whether no inner knot is there more often than the degree allows, and none of them at an end.
bool isContinuous(const std::vector<double>& knots, int degree) {
    const std::size_t first = at(degree);
    const std::size_t last = knots.size() - first - 1;
    for (std::size_t k = first + 1; k < last; ++k)
        if (knots[k] <= knots[first] || knots[k] >= knots[last] || knots[k] >= knots[k + first]) return false;
    return true;
}

void requireMatching(const Layout& layout, const std::vector<Patch>& patches) {
    if (layout.segments.size() != patches.size())
        throw Error("surfaces",
                    "there are " + std::to_string(patches.size()) + " patches for " +
                        std::to_string(layout.segments.size()) + " segments",
                    "Fit the surfaces anew");
    for (std::size_t k = 0; k < patches.size(); ++k) {
        const Patch& patch = patches[k];
        const auto require = [&](bool holds, const char* otherwise) {
            if (!holds) throw Error("patch " + std::to_string(k), otherwise, "Fit the surfaces anew");
        };
        for (std::size_t d = 0; d < 2; ++d) {
            const auto& knots = patch.knots[d];
            const int degree = patch.degree[d];
            const bool cubic = degree == 3 && patch.count[d] >= 4;
            const bool lower = degree > 0 && degree < 3 && patch.count[d] == degree + 1;
            require(cubic || lower, "is neither cubic nor of a lower degree without inner knots");
            const std::size_t due = at(patch.count[d]) + at(degree) + 1;
            const std::array<double, 2> range{0, static_cast<double>(layout.segments[k].size[d])};
            require(knots.size() == due && std::ranges::is_sorted(knots) &&
                        (!lower || clampedDegree(knots) == degree) && domain(knots, degree) == range,
                    "has knots that do not belong to its segment");
            require(isContinuous(knots, degree), "has one knot so often that it falls apart there");
        }
        require(patch.controlPoints.size() == at(patch.count[0]) * at(patch.count[1]),
                "has a wrong number of control points");
    }
}

/// The part between two values of u.
Patch strip(const Patch& patch, double begin, double end) {
    if (begin == 0 && end == patch.knots[0].back()) return patch;
    Patch result = patch;
    result.controlPoints.clear();
    const int degree = patch.degree[0];
    for (const SplineCurve& row : rowCurves(patch)) {
        const SplineCurve part = restricted(row, begin, end);
        const auto points = degreeReduced(part, degree);
        result.controlPoints.insert(result.controlPoints.end(), points.begin(), points.end());
        result.knots[0] = part.knots;
        result.count[0] = static_cast<int>(points.size());
    }
    // Curves are cubic; a lower degree has no inner knots.
    const auto surplus = static_cast<std::ptrdiff_t>(3 - degree);
    result.knots[0].erase(result.knots[0].begin(), result.knots[0].begin() + surplus);
    result.knots[0].erase(result.knots[0].end() - surplus, result.knots[0].end());
    return result;
}

} // namespace

void FacePatches::add(Segment segment, Patch patch, std::vector<std::size_t> segments) {
    layout.segments.push_back(std::move(segment));
    patches.push_back(std::move(patch));
    origins.push_back(std::move(segments));
}

FacePatches facePatches(const Layout& layout, const std::vector<Patch>& patches) {
    requireMatching(layout, patches);
    FacePatches result;
    for (std::size_t k = 0; k < patches.size(); ++k)
        result.add(layout.segments[k], clamped(patches[k]), {k});
    return result;
}

Segment partOf(const std::vector<VertexId>& vertices, const Segment& segment, const std::array<int, 2>& from,
               const std::array<int, 2>& to) {
    const auto vertexAt = [&](int i, int j) { return vertices[at(j) * (at(segment.size[0]) + 1) + at(i)]; };
    Segment part;
    part.size = {to[0] - from[0], to[1] - from[1]};
    for (int side = 0; side < 4; ++side) {
        for (int k = 0; k <= part.size[directionAlong(side)]; ++k) {
            const auto [i, j] = placeOnSide(part.size, side, k);
            part.sides[at(side)].push_back(vertexAt(from[0] + i, from[1] + j));
        }
        part.corners[at(side)] = part.sides[at(side)].front();
    }
    for (int j = from[1]; j < to[1]; ++j)
        for (int i = from[0]; i < to[0]; ++i)
            part.faces.push_back(segment.faces[at(j) * at(segment.size[0]) + at(i)]);
    return part;
}

Patch partOf(const Patch& clampedPatch, const std::array<int, 2>& from, const std::array<int, 2>& to) {
    const Patch columns = strip(clampedPatch, from[0], to[0]);
    return transposed(strip(transposed(columns), from[1], to[1]));
}

} // namespace qm

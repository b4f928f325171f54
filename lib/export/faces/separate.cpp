#include "base/at.h"
#include "base/sort_unique.h"
#include "export/faces/face_patches.h"
#include "export/geometry/geometry.h"
#include "layout/sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace qm {
namespace {

/// Inner grid lines at which a face is cut, ascending, for u and v.
using Cuts = std::array<std::vector<int>, 2>;

/// Where the patch may be only C0: on grid lines, for no fit has its joints elsewhere.
Cuts c0Lines(const Patch& patch) {
    Cuts cuts;
    for (std::size_t d = 0; d < 2; ++d) {
        const auto& knots = patch.knots[d];
        const std::size_t degree = at(patch.degree[d]);
        for (std::size_t k = degree + 1; k + 2 * degree < knots.size(); ++k)
            if (knots[k] == knots[k + degree - 1] && knots[k] == std::round(knots[k]))
                cuts[d].push_back(static_cast<int>(knots[k]));
    }
    return cuts;
}

/// What other programs do with every edge of a face takes time in proportion to the whole face, so that a
/// side with thousands of edges would hold them up: it gets no more than this.
constexpr std::size_t maxEdges = 128;

/// Cuts sides of too many edges at some of the T-joints there.
void cutLongSides(const Segment& segment, const std::vector<bool>& isCorner, Cuts& cuts) {
    for (int side = 0; side < 4; ++side) {
        const auto& line = segment.sides[at(side)];
        std::size_t count = 0;
        for (std::size_t k = 1; k + 1 < line.size(); ++k)
            if (isCorner[at(line[k])] && ++count % maxEdges == 0)
                cuts[directionAlong(side)].push_back(static_cast<int>(alongSide(side, k, line.size() - 1)));
    }
    for (std::vector<int>& lines : cuts)
        sortUnique(lines);
}

/// A vertex on a face's border, and its place in the grid.
struct BorderVertex {
    VertexId vertex;
    std::array<int, 2> at{};
};

/// In the order of the vertices.
std::vector<BorderVertex> borderVertices(const Segment& segment) {
    std::vector<BorderVertex> result;
    for (int side = 0; side < 4; ++side)
        for (int k = 0; k < segment.size[directionAlong(side)]; ++k)
            result.push_back({segment.sides[at(side)][at(k)], placeOnSide(segment.size, side, k)});
    std::ranges::stable_sort(result, {}, [](const BorderVertex& entry) { return entry.vertex.idx(); });
    return result;
}

/// Adds as few cuts as possible such that one lies strictly inside each interval.
void stab(std::vector<std::array<int, 2>> intervals, std::vector<int>& cuts) {
    std::erase_if(intervals, [&](const std::array<int, 2>& interval) {
        return std::ranges::any_of(cuts, [&](int cut) { return cut > interval[0] && cut < interval[1]; });
    });
    std::ranges::sort(intervals, {}, [](const std::array<int, 2>& interval) { return interval[1]; });
    for (std::size_t k = 0; k < intervals.size();) {
        std::array<int, 2> common = intervals[k];
        for (++k; k < intervals.size() && std::max(common[0], intervals[k][0]) + 2 <= common[1]; ++k)
            common[0] = std::max(common[0], intervals[k][0]);
        cuts.push_back((common[0] + common[1]) / 2);
    }
    std::ranges::sort(cuts);
}

/// Parts the places of every vertex that the border passes more than once, across the longer way.
void addContacts(const Segment& segment, Cuts& cuts) {
    const auto border = borderVertices(segment);
    std::array<std::vector<std::array<int, 2>>, 2> intervals;
    for (std::size_t k = 0; k < border.size(); ++k)
        for (std::size_t l = k + 1; l < border.size() && border[l].vertex == border[k].vertex; ++l) {
            const auto& p = border[k].at;
            const auto& q = border[l].at;
            const std::size_t d = std::abs(p[0] - q[0]) >= std::abs(p[1] - q[1]) ? 0 : 1;
            intervals[d].push_back({std::min(p[d], q[d]), std::max(p[d], q[d])});
        }
    for (std::size_t d = 0; d < 2; ++d)
        stab(std::move(intervals[d]), cuts[d]);
}

} // namespace

bool touchesItself(const Segment& segment) {
    const auto border = borderVertices(segment);
    return std::ranges::adjacent_find(border, {}, &BorderVertex::vertex) != border.end();
}

FacePatches separated(const QuadMesh& mesh, FacePatches faces, double tolerance) {
    FacePatches result;
    const auto isCorner = cornerMarks(mesh, faces.layout);
    for (std::size_t f = 0; f < faces.patches.size(); ++f) {
        Segment& segment = faces.layout.segments[f];
        faces.patches[f] = withoutNeedlessKnots(faces.patches[f], tolerance);
        Cuts cuts = c0Lines(faces.patches[f]);
        cutLongSides(segment, isCorner, cuts);
        addContacts(segment, cuts);
        if (cuts[0].empty() && cuts[1].empty()) {
            result.add(std::move(segment), std::move(faces.patches[f]), std::move(faces.origins[f]));
            continue;
        }
        for (std::size_t d = 0; d < 2; ++d) {
            cuts[d].insert(cuts[d].begin(), 0);
            cuts[d].push_back(segment.size[d]);
        }
        const auto vertices = vertexGrid(mesh, segment);
        for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j)
            for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
                const std::array<int, 2> from{cuts[0][i], cuts[1][j]};
                const std::array<int, 2> to{cuts[0][i + 1], cuts[1][j + 1]};
                result.add(partOf(vertices, segment, from, to), partOf(faces.patches[f], from, to),
                           faces.origins[f]);
            }
    }
    return result;
}

} // namespace qm

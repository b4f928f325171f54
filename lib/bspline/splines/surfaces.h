/// \file Bicubic B-spline patches, one for each segment (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// Parameters of a patch: u and v.
using Parameters = std::array<double, 2>;

/// A rectangle of parameters: its ends along u and along v.
using ParameterBox = std::array<std::array<double, 2>, 2>;

[[nodiscard]] constexpr Parameters middleOf(const ParameterBox& box) {
    return {0.5 * (box[0][0] + box[0][1]), 0.5 * (box[1][0] + box[1][1])};
}

/// A tensor-product B-spline surface. Parameter u runs along the segment's side 0, v along its side 1; knots
/// are full vectors (control points + degree + 1 of them) and need not be clamped: the surface is what lies
/// between knot [degree] and knot [count] of each direction. There it is parameterised like the segment's
/// grid: vertex (i, j) belongs to u = i, v = j. Control point (i, j), i along u, is
/// controlPoints[j * count[0] + i].
struct Patch {
    SegmentId segment;
    std::array<int, 2> degree{3, 3};
    std::array<std::vector<double>, 2> knots;
    std::array<int, 2> count{};
    std::vector<Point> controlPoints;
};

/// How far surfaces are from what they were fitted to, from the mesh, and from one another. Lengths are in
/// the mesh's unit, those called relative are fractions of the diagonal of its bounding box; angles in
/// degrees.
struct Deviation {
    /// Distances from the reference, both ways: no point is farther away than `max`, which is at most a few
    /// per cent too large.
    double max = 0;
    double rms = 0;
    double percentile95 = 0;
    double maxRelative = 0;
    double rmsRelative = 0;
    double percentile95Relative = 0;
    double maxFromFacets = 0; ///< the same from the mesh's quads, taken as bilinear
    double rmsFromFacets = 0;
    double maxFromVertices = 0; ///< from the mesh's vertices to the surfaces
    double rmsFromVertices = 0;
    double largestGap = 0; ///< between neighbouring patches along their common border
    double largestGapRelative = 0;
    double largestNormalAngle = 0; ///< between neighbours' normals across smooth borders
    double rmsNormalAngle = 0;
    double percentile95NormalAngle = 0;
    double largestInnerNormalAngle = 0; ///< across the lines within patches where tangents may jump
    double largestNormalDeviation = 0;  ///< between the normals of surface and reference
    double rmsNormalDeviation = 0;
    double bendingRatio = 1; ///< the surfaces' sum of squared curvatures as a multiple of the reference's
    /// Pieces between knots whose normal may vanish or turn over against the reference's.
    std::size_t folds = 0;
};

/// A place of the layout: parameters of one of its patches.
struct LayoutPlace {
    std::size_t patch = 0;
    Parameters at{};
};

/// The distances of surfaces from a scan's triangles, where it shows something.
struct ScanDeviations {
    /// The largest distance that was found at a point: boxes over many small triangles are bounded too
    /// loosely for an upper bound.
    double max = 0;
    double rms = 0;
    double percentile95 = 0;
    LayoutPlace farthest; ///< where `max` was found
};

/// How surfaces and the scan that they were fitted to belong together.
struct ScanFigures : ScanDeviations {
    double coverage = 0; ///< share of the mesh that the scan shows
    double noise = 0;    ///< of the scan: standard deviation of its points from a smooth surface
};

struct Surfaces {
    std::vector<Patch> patches; ///< in the order of the segments
    /// Borders between patches across which they are not smooth, as paths along edges of the mesh; nothing if
    /// that is not known.
    std::optional<std::vector<std::vector<VertexId>>> creases;
    Deviation deviation;
    std::vector<Deviation> ofPatch;  ///< in the order of the patches; borders count for both neighbours
    LayoutPlace farthest;            ///< where the largest distance from the reference was found
    std::vector<LayoutPlace> folds;  ///< a place in every piece that may fold, by patch
    std::optional<ScanFigures> scan; ///< if the reference is one
    bool endedEarly = false;         ///< whether a time limit ended the fit; not part of documents
};

/// All patches' control points together.
[[nodiscard]] inline std::size_t controlPointCount(const std::vector<Patch>& patches) {
    std::size_t sum = 0;
    for (const Patch& patch : patches)
        sum += patch.controlPoints.size();
    return sum;
}

} // namespace qm

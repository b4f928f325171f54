/// \file Bicubic B-spline patches, one for each segment (docs/METHOD.md#smooth-fit).
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

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

/// Distances between surfaces and mesh, in the mesh's unit and as fractions of the diagonal of the bounding
/// box; angles in degrees. A mesh is taken as its bilinear quads. Both ways are measured: from the surfaces
/// to the nearest point of the mesh, and from the mesh to the surfaces.
struct Deviation {
    double max = 0;
    double rms = 0;
    double percentile95 = 0;
    double maxRelative = 0;
    double rmsRelative = 0;
    double percentile95Relative = 0;
    double largestGap = 0;             ///< between neighbouring patches along their common border
    double largestGapRelative = 0;     ///<
    double largestKink = 0;            ///< between neighbours' normals across smooth borders
    double rmsKink = 0;                ///<
    double largestNormalDeviation = 0; ///< between the normals of surface and quad at the quads' centres
};

struct Surfaces {
    std::vector<Patch> patches; ///< in the order of the segments
    Deviation deviation;
    std::vector<Deviation> ofPatch; ///< in the order of the patches; borders count for both neighbours
};

/// All patches' control points together.
[[nodiscard]] inline std::size_t controlPointCount(const std::vector<Patch>& patches) {
    std::size_t sum = 0;
    for (const Patch& patch : patches)
        sum += patch.controlPoints.size();
    return sum;
}

} // namespace qm

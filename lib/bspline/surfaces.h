/// \file Bicubic B-spline patches, one for each segment (method 9; paper 5).
#pragma once

#include "base/ids.h"
#include "mesh/quad_mesh.h"

#include <array>
#include <vector>

namespace qm {

/// A tensor-product B-spline surface. Parameter u runs along the segment's side 0, v along its side 1; knots
/// are full vectors (control points + degree + 1 of them). Control point (i, j), i along u, is
/// controlPoints[j * count[0] + i].
struct Patch {
    SegmentId segment;
    std::array<int, 2> degree{3, 3};
    std::array<std::vector<double>, 2> knots;
    std::array<int, 2> count{};
    std::vector<Point> controlPoints;
};

/// Distances between surfaces and mesh, in the mesh's unit and as fractions of the bounding box's diagonal.
struct Deviation {
    double max = 0;
    double rms = 0;
    double percentile95 = 0;
    double maxRelative = 0;
    double rmsRelative = 0;
    double largestGap = 0;  ///< between neighbouring patches along their common border
    double largestKink = 0; ///< angle between neighbouring patches' normals across smooth borders, degrees
    double rmsKink = 0;
};

struct Surfaces {
    std::vector<Patch> patches; ///< in the order of the segments
    Deviation deviation;
    std::vector<Deviation> ofPatch; ///< in the order of the patches
};

} // namespace qm

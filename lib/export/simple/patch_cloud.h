/// \file Points of a patch with their normals, by which the simple shape that they lie on is found.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/simple/simple_shape.h"

#include <Eigen/Core>

#include <cstddef>

namespace qm {

/// Points moved and scaled to unit size about the origin.
struct PatchCloud {
    Eigen::Vector3d centre{0, 0, 0};
    double size = 1;
    double area = 0;        ///< about; not scaled
    OrientedPoints samples; ///< empty if the patch has no extent
};

/// Samples every knot interval, except where the patch has no normal.
/// \param max  largest number of samples in either direction
[[nodiscard]] PatchCloud cloudOf(const Patch& patch, std::size_t max);

/// The same points about another origin and in another unit.
[[nodiscard]] PatchCloud inFrame(PatchCloud cloud, const Eigen::Vector3d& centre, double size);

/// All points of both, in the frame of the first.
void append(PatchCloud& cloud, const PatchCloud& more);

/// The same points about the middle of their bounding box, in units of its diagonal.
[[nodiscard]] PatchCloud centred(PatchCloud cloud);

} // namespace qm

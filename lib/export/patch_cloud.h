/// \file Points of a patch with their normals, for finding the simple shape that they lie on.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/simple_shape_fit.h"

#include <Eigen/Core>

#include <cstddef>

namespace qm {

/// Moved and scaled to unit size about the origin.
struct PatchCloud {
    Eigen::Vector3d centre{0, 0, 0};
    double size = 1;
    OrientedPoints samples; ///< none where the patch has no size
};

/// Samples in every knot interval, none where the patch has no normal.
/// \param max  how many there are at most in either direction
[[nodiscard]] PatchCloud cloudOf(const Patch& patch, std::size_t max);

/// The same points about another origin and in another unit.
[[nodiscard]] PatchCloud inFrame(PatchCloud cloud, const Eigen::Vector3d& centre, double size);

} // namespace qm

/// \file Around which middle, along which axes and how far points spread.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace qm {

struct PrincipalAxes {
    Eigen::Vector3d middle;
    Eigen::Vector3d extents; ///< the RMS distance from the middle along each axis, ascending
    Eigen::Matrix3d axes;    ///< unit columns, in the order of the extents
};

/// \param points  one at least
[[nodiscard]] PrincipalAxes principalAxes(const std::vector<Eigen::Vector3d>& points);

} // namespace qm

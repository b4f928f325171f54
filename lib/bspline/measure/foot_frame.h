/// \file Coordinates in the tangents of a surface at a foot.
#pragma once

#include "bspline/measure/foot_search.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <optional>

namespace qm {

struct FootFrame {
    /// The scalar products of these with a difference are its components along the tangents, as parameters.
    std::array<Eigen::Vector3d, 2> dual;
    Eigen::Vector3d normal; ///< unit
};

/// None where the tangents are nearly parallel or vanish.
[[nodiscard]] inline std::optional<FootFrame> footFrame(const Foot& foot) {
    constexpr double minSquare = 1e-8; // of the sine of the angle between them
    const Eigen::Vector3d across = foot.du.cross(foot.dv);
    const double area = across.squaredNorm();
    if (!(area > minSquare * foot.du.squaredNorm() * foot.dv.squaredNorm())) return {};
    return FootFrame{{foot.dv.cross(across) / area, across.cross(foot.du) / area}, across / std::sqrt(area)};
}

} // namespace qm

/// \file Borders where patches meet smoothly, and still must where other surfaces replace them.
#pragma once

#include "export/simple/simple_shape.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A border where two patches meet smoothly, by points along it.
struct SmoothBorder {
    std::array<std::size_t, 2> patches{};
    std::vector<Eigen::Vector3d> points;
    std::array<std::vector<Eigen::Vector3d>, 2> normals; ///< by patch; of unit length
};

/// Largest angle, in degrees, by which surfaces that replace patches may bend a border that was smooth. No
/// shading shows it, and programs that round, offset or select along smooth edges take more for smooth.
constexpr double maxNewAngle = 1;

/// A surface in the place of a patch.
struct PlacedShape {
    SimpleShape shape;  ///< in the mesh's unit
    int side = 1;       ///< -1 if its normal is opposite to the patch's
    double weight = 0;  ///< where two do not go together, the one with less gives way
    bool mayGo = false; ///< the patch may stay as it is instead
};

/// Takes surfaces away until no border bends by more than `maxNewAngle`. Linear in the borders.
/// \param shapes  by patch
void keepSmooth(const std::vector<SmoothBorder>& borders, std::vector<std::optional<PlacedShape>>& shapes);

} // namespace qm

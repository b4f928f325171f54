/// \file A point as Eigen knows it.
#pragma once

#include "mesh/quad_mesh.h"

#include <Eigen/Core>

namespace qm {

[[nodiscard]] inline Eigen::Vector3d vector(const Point& point) {
    return {point[0], point[1], point[2]};
}

} // namespace qm

/// \file Points as vectors of Eigen, whose arithmetic is faster, and back; and indices as Eigen counts.
#pragma once

#include "mesh/quad_mesh.h"

#include <Eigen/Core>

#include <cstddef>

namespace qm {

[[nodiscard]] inline Eigen::Vector3d vector(const Point& point) {
    return {point[0], point[1], point[2]};
}

[[nodiscard]] inline Point point(const Eigen::Vector3d& vector) {
    return {vector[0], vector[1], vector[2]};
}

[[nodiscard]] constexpr Eigen::Index eigenIndex(std::size_t index) {
    return static_cast<Eigen::Index>(index);
}

} // namespace qm

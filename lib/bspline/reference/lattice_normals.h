/// \file The points and normals of a surface on the lattice of a mesh.
#pragma once

#include "bspline/reference/reference_grid.h"
#include "bspline/splines/eigen_point.h"
#include "layout/layout.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

struct LatticeNormals {
    std::vector<std::vector<std::size_t>> numbers; ///< by grid and point: the lattice point
    std::vector<std::vector<std::optional<Eigen::Vector3d>>> oneSided; ///< by grid and point, unit length
    // By lattice point:
    std::vector<Eigen::Vector3d> points;
    /// Means of the one-sided ones, unit length; none at sharp points, nor where no grid has the point, as at
    /// isolated vertices.
    std::vector<std::optional<Eigen::Vector3d>> normals;
    std::vector<bool> sharp; ///< the one-sided ones differ, or one is missing
};

/// \param surface  by segment, all with the same steps
[[nodiscard]] LatticeNormals latticeNormals(const QuadMesh& mesh, const Layout& layout,
                                            const std::vector<ReferenceGrid>& surface, unsigned jobs);

} // namespace qm

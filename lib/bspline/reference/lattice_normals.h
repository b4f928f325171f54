/// \file The points and normals of a surface on the lattice of a mesh.
#pragma once

#include "bspline/reference/reference_grid.h"
#include "bspline/splines/eigen_point.h"
#include "layout/layout.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace qm {

struct LatticeNormals {
    std::vector<std::vector<std::size_t>> numbers; ///< by grid and point: the lattice point
    /// By grid and point: unit length, or 0 if there is none.
    std::vector<std::vector<Eigen::Vector3d>> oneSided;
    // By lattice point:
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals; ///< means of the one-sided ones
    std::vector<bool> sharp;              ///< those differ
    std::vector<bool> used;               ///< some grid has it; isolated vertices are in none
};

/// \param surface  by segment, all with the same steps
[[nodiscard]] LatticeNormals latticeNormals(const QuadMesh& mesh, const Layout& layout,
                                            const std::vector<ReferenceGrid>& surface, unsigned jobs);

} // namespace qm

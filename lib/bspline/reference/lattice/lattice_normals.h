/// \file Points and normals of a surface on the lattice of a mesh.
#pragma once

#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/eigen_point.h"
#include "layout/layout.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

struct LatticeNormals {
    std::vector<std::vector<std::size_t>> numbers; ///< by grid and point: the lattice point
    /// By grid and point, unit length; seen from that grid alone.
    std::vector<std::vector<std::optional<Eigen::Vector3d>>> oneSided;
    // By lattice point:
    std::vector<Eigen::Vector3d> points;
    /// Mean of the one-sided normals, unit length; none at sharp points, nor at points of no grid, such as
    /// isolated vertices.
    std::vector<std::optional<Eigen::Vector3d>> normals;
    std::vector<bool> sharp; ///< the one-sided normals differ, or one is missing

    /// Calls a function with every grid, each of its points, and the lattice point that this is.
    template <class Function> void forEachPoint(const Function& function) const {
        for (std::size_t g = 0; g < numbers.size(); ++g)
            for (std::size_t k = 0; k < numbers[g].size(); ++k)
                function(g, k, numbers[g][k]);
    }
};

/// \param surface  by segment, all with the same steps
[[nodiscard]] LatticeNormals latticeNormals(const QuadMesh& mesh, const Layout& layout,
                                            const std::vector<ReferenceGrid>& surface, unsigned jobs);

} // namespace qm

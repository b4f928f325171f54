/// \file The tilts of tangent planes for which all quads together bend least.
#pragma once

#include "bspline/reference/bending/quad_bending.h"
#include "mesh/quad_mesh.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace qm {

/// The bending energy of one quad in single precision, which is enough for tilts and compact enough to be
/// kept for every quad of a mesh.
class BendingTerm {
public:
    BendingTerm() = default; ///< no energy
    /// \param vertices  by corner
    BendingTerm(const std::array<VertexId, 4>& vertices, const QuadBending& bending);

    [[nodiscard]] const std::array<VertexId, 4>& vertices() const { return vertices_; }
    [[nodiscard]] CornerTilts right() const { return right_.cast<double>(); }
    [[nodiscard]] Eigen::Matrix<double, 12, 12> matrix() const;

private:
    std::array<VertexId, 4> vertices_{VertexId(0), VertexId(0), VertexId(0), VertexId(0)};
    std::array<float, 78> upper_{}; ///< half of the symmetric matrix, row by row
    Eigen::Matrix<float, 12, 1> right_ = Eigen::Matrix<float, 12, 1>::Zero();
};

/// Minimises the sum of all terms by conjugate gradients.
/// \param vertices  number of vertices
/// \return by vertex: its tilts; zero where no term depends on them
[[nodiscard]] std::vector<Eigen::Vector3d> minBendingTilts(const std::vector<BendingTerm>& terms,
                                                           std::size_t vertices, unsigned jobs);

} // namespace qm

/// \file Dihedral angles and the cost of an edge (docs/METHOD.md#cost).
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The unsigned dihedral angle of every edge, in radians, 0 to pi, by edge index; 0 on the mesh boundary and
/// beside a face without a normal. The normal of a quad is the mean of the unit normals of its two triangles,
/// split along the diagonal from the face's first vertex; a triangle without area has none.
[[nodiscard]] std::vector<double> dihedralAngles(const QuadMesh& mesh);

/// Edges of larger dihedral angles count as sharp unless told otherwise: the paper's rho, radians.
constexpr double defaultRho = 0.45;

/// The weights of the paper's cost.
struct CostOptions {
    double alpha = 0.4;   ///< penalty of a flat edge
    double epsilon = 0.2; ///< an edge is flat below this angle, radians; 1.0 suits models with sharp edges
};

/// Cost of every edge, by edge index: -theta + alpha if theta < epsilon.
[[nodiscard]] std::vector<double> edgeCosts(const std::vector<double>& dihedralAngles,
                                            const CostOptions& options);

} // namespace qm

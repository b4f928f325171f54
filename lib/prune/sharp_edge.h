/// \file Edges that separate tangent planes (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "base/at.h"
#include "mesh/quad_geometry.h"

#include <vector>

namespace qm {

/// Whether an edge lies on the boundary, or its dihedral angle is above 0.6 radians. Beside a folded quad the
/// angle is unreliable, so the edge counts as smooth.
/// \param dihedralAngles  by edge index, radians
[[nodiscard]] inline bool isSharp(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                  HalfedgeId halfedge) {
    constexpr double sharp = 0.6;
    const EdgeId edge = mesh.edge_handle(halfedge);
    if (mesh.is_boundary(edge)) return true;
    return dihedralAngles[at(edge)] > sharp && !isFolded(mesh, mesh.face_handle(halfedge)) &&
           !isFolded(mesh, mesh.opposite_face_handle(halfedge));
}

} // namespace qm

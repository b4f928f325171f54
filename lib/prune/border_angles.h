/// \file The angles of borders: which are sharp, and by how much one turns at a vertex
/// (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "base/at.h"
#include "mesh/angle_between.h"
#include "mesh/quad_geometry.h"

#include <array>
#include <vector>

namespace qm {

/// Whether an edge separates tangent planes: it lies on the boundary, or its dihedral angle is above 0.6
/// radians. Beside a folded quad the angle is unreliable, so the edge counts as smooth.
/// \param dihedralAngles  by edge index, radians
[[nodiscard]] inline bool isSharp(const QuadMesh& mesh, const std::vector<double>& dihedralAngles,
                                  HalfedgeId halfedge) {
    constexpr double sharp = 0.6;
    const EdgeId edge = mesh.edge_handle(halfedge);
    if (mesh.is_boundary(edge)) return true;
    return dihedralAngles[at(edge)] > sharp && !isFolded(mesh, mesh.face_handle(halfedge)) &&
           !isFolded(mesh, mesh.opposite_face_handle(halfedge));
}

/// The two halfedges that leave a vertex on the line across, on the left and on the right of who arrives.
/// \param arriving  ends at an interior regular vertex
[[nodiscard]] inline std::array<HalfedgeId, 2> crossingAt(const QuadMesh& mesh, HalfedgeId arriving) {
    return {mesh.next_halfedge_handle(arriving), mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(
                                                     mesh.opposite_halfedge_handle(arriving)))};
}

/// The angle in degrees, 0 to 180, between arriving over one edge and leaving over the other.
/// \param left, right  halfedges that leave the vertex
[[nodiscard]] inline double turnBetween(const QuadMesh& mesh, HalfedgeId left, HalfedgeId right) {
    const Point vertex = mesh.point(mesh.from_vertex_handle(left));
    const Point before = vertex - mesh.point(mesh.to_vertex_handle(left)),
                after = mesh.point(mesh.to_vertex_handle(right)) - vertex;
    return degreesBetween(before, after);
}

} // namespace qm

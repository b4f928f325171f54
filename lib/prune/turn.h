/// \file The angle by which a border turns at a vertex (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "mesh/angle_between.h"
#include "mesh/quad_mesh.h"

#include <array>

namespace qm {

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

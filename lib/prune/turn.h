/// \file The angle by which a border turns at a vertex (docs/METHOD.md#pruning, smoothness).
#pragma once

#include "mesh/quad_mesh.h"

#include <cmath>
#include <numbers>

namespace qm {

/// The angle in degrees, 0 to 180, between arriving over one edge and leaving over the other.
/// \param left, right  halfedges that leave the vertex
[[nodiscard]] inline double turnBetween(const QuadMesh& mesh, HalfedgeId left, HalfedgeId right) {
    const Point vertex = mesh.point(mesh.from_vertex_handle(left));
    const Point before = vertex - mesh.point(mesh.to_vertex_handle(left)),
                after = mesh.point(mesh.to_vertex_handle(right)) - vertex;
    return std::atan2((before % after).norm(), before | after) * 180 / std::numbers::pi;
}

} // namespace qm

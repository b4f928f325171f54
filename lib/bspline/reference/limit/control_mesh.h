/// \file The control points whose Catmull-Clark limit passes through a mesh's vertices
/// (docs/METHOD.md#halstead-1993).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

struct ControlMesh {
    std::vector<Point> points;      ///< by vertex: its control point
    std::vector<bool> interpolates; ///< by vertex: whether the limit passes through it, up to rounding
};

/// Solves for the control points by successive over-relaxation, in time linear in the mesh. For a connected
/// component without a solution, or with one far from its vertices, the vertices serve as control points and
/// the limit smooths them. If all vertices have valence 3, as those of a cube without creases, the equations
/// are singular, and only regular positions of the vertices have a solution.
[[nodiscard]] ControlMesh interpolatingControlMesh(const QuadMesh& mesh,
                                                   const std::vector<VertexRule>& rules);

} // namespace qm

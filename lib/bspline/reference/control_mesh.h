/// \file The control points whose Catmull-Clark limit passes through a mesh's vertices
/// (docs/METHOD.md#halstead-1993).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

struct ControlMesh {
    std::vector<Point> points;      ///< by vertex
    std::vector<bool> interpolates; ///< by vertex: its limit is the mesh's vertex, to rounding
};

/// Solves for the control points by successive over-relaxation, in time linear in the mesh. Where a connected
/// component has no solution or one far from its vertices, they are the control points themselves and the
/// limit smooths them: a cube without creases is such a case, for the equations of a mesh that has only
/// vertices of three edges are singular.
[[nodiscard]] ControlMesh interpolatingControlMesh(const QuadMesh& mesh,
                                                   const std::vector<VertexRule>& rules);

} // namespace qm

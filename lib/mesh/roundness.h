/// \file How round a surface is across a line of edges, although its quads are coarse.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Lines of more roundness are round, not sharp. Hardly any sharp edge of a finely meshed machine part is
/// above 0.6, and few edges of coarse meshes of smooth shapes are below.
inline constexpr double roundLine = 0.5;

/// Tells a crease from a coarse mesh of a round part, whose dihedral angles are large everywhere: 30 degrees
/// on a cylinder of twelve quads around. Compares the bends at the edges of a line with those at the opposite
/// edges of the quads on both sides, about the same axes (docs/METHOD.md#roundness).
/// \param line  halfedges of edges inside the mesh
/// \return the sum of the lesser bends of both sides as a share of the sum of the line's own: at most 1, and
/// about 1 where all is round; 0 beside a plane, or where the line is sharper than round parts are
[[nodiscard]] double roundness(const QuadMesh& mesh, const std::vector<HalfedgeId>& line);

} // namespace qm

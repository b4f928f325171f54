/// \file Closing the small holes that a remesher leaves (docs/METHOD.md#closing-holes).
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/triangles/triangles.h"

namespace qm {

/// Fills boundary loops of up to eight edges with quads, and a triangle where their number is odd, unless the
/// scan has a hole there, too: what is nearest to the middle of the loop lies on the scan's boundary. Two
/// triangles become quads by a row of new edges from one to the other, which halves the quads on its way. A
/// triangle that no such row reaches remains a hole.
/// \param scan  that the mesh was made of
[[nodiscard]] QuadMesh closeHoles(QuadMesh mesh, const Triangles& scan);

} // namespace qm

/// \file Closing the small holes that a remesher leaves (docs/METHOD.md#closing-holes).
#pragma once

#include "mesh/quad_mesh.h"

namespace qm {

/// Fills every boundary loop of up to eight edges with quads, and a triangle where their number is odd. Two
/// triangles become quads by a row of new edges from one to the other, which halves the quads on its way. A
/// triangle that no such row reaches remains a hole.
[[nodiscard]] QuadMesh closeHoles(QuadMesh mesh);

} // namespace qm

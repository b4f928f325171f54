/// \file Making quads of a polygon mesh by subdivision, for qm-remesh.
#pragma once

#include "cli/tool.h"

namespace qm {

/// Reads polygons, and writes the quads into which one step of subdivision divides them (see
/// `subdividePolygons`). Warns of meshes that consist of triangles.
/// \param rho  edges of larger dihedral angles are sharp, radians
/// \return the exit status
[[nodiscard]] int subdivideInput(const Tool& tool, double rho);

} // namespace qm

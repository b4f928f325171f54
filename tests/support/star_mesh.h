/// \file Quads around one vertex.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm::testing {

/// Quads around vertex 0, in the plane z = 0, counter-clockwise; vertex 1 + k ends the k-th edge that leaves
/// it.
/// \param turn  degrees that they fill together; 360: they close
[[nodiscard]] QuadMesh star(int quads, double turn = 360);

} // namespace qm::testing

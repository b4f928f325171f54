/// \file A mesh of any size and complexity for timing kernels.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm::bench {

/// The surface of a flight of `steps` stairs in the corner of three walls, with every unit square divided
/// into refinement x refinement quads. It is closed and has 3 steps (steps + 1) refinement^2 quads; the
/// number of ordinary junctions grows with steps^2. The surface is slightly bent, so that dihedral angles
/// differ between edges.
[[nodiscard]] QuadMesh staircase(int steps, int refinement);

} // namespace qm::bench

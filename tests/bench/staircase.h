/// \file A mesh of any size and complexity for timing kernels.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm::bench {

/// The surface of a flight of `steps` stairs that meets three walls in a corner, every unit square divided
/// into refinement x refinement quads: closed, 3 steps (steps + 1) refinement^2 quads, its number of ordinary
/// junctions grows with steps^2. The surface is bent a little, so that dihedral angles differ from edge to
/// edge.
[[nodiscard]] QuadMesh staircase(int steps, int refinement);

} // namespace qm::bench

/// \file Generated meshes with many motorcycle graphs.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm::bench {

/// A slab with cubes on it here and there, all alike: the number of graphs grows by a factor of 48 or so for
/// each.
[[nodiscard]] QuadMesh studs(int count);

/// A torus as the paper's: 16 extraordinary vertices, 32 undirected separatrices, 68 vertices of the base
/// complex. It is a square ring of square bars, one of which is cut through and joined again with a twist.
[[nodiscard]] QuadMesh paperTorus();

} // namespace qm::bench

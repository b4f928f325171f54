/// \file Generated meshes with many motorcycle graphs.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm::bench {

/// A slab with equal cubes on it at some distance; each cube multiplies the number of graphs by about 48.
[[nodiscard]] QuadMesh studs(int count);

/// A torus like the paper's, with 16 extraordinary vertices, 32 undirected separatrices and 68 vertices of
/// the base complex: a square ring of square bars, one of which is cut and joined again with a twist.
[[nodiscard]] QuadMesh paperTorus();

} // namespace qm::bench

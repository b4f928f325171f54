/// \file Where a mesh ends: its holes, and the outer rim of an open sheet.
#pragma once

#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A closed path of boundary edges.
struct BoundaryLoop {
    VertexId vertex; ///< the lowest on it
    std::size_t edges = 0;
    double length = 0; ///< in the mesh's unit
};

/// All of them, the longest first, those of one length by their vertex. Linear in the mesh, but for sorting.
[[nodiscard]] std::vector<BoundaryLoop> boundaryLoops(const QuadMesh& mesh);

} // namespace qm

/// \file The boundary of a mesh as loops: its holes, and the outer rim of an open sheet.
#pragma once

#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A closed path of boundary edges.
struct BoundaryLoop {
    VertexId vertex; ///< the lowest vertex of the loop
    std::size_t edges = 0;
    double length = 0; ///< in the mesh's unit
};

/// The halfedges of every boundary loop, one after the other, in the order of the first of them.
[[nodiscard]] std::vector<std::vector<HalfedgeId>> boundaryPaths(const QuadMesh& mesh);

/// All boundary loops, the longest first; loops of one length are in the order of their vertices. Linear in
/// the mesh, apart from sorting.
[[nodiscard]] std::vector<BoundaryLoop> boundaryLoops(const QuadMesh& mesh);

} // namespace qm

/// \file Faces that hang together: shells, and which of them are inside out.
#pragma once

#include "export/shared_edges.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// Faces that hang together.
struct BoundaryPart {
    std::vector<std::size_t> faces; ///< ascending
    bool closed = false;            ///< every edge has faces on both sides
    bool inward = false; ///< closed, and its faces look to the inside: all of them are to be turned over
};

/// In the order of their lowest faces.
/// \param layout  a segment for every face
/// \param shared  its edges
[[nodiscard]] std::vector<BoundaryPart> boundaryParts(const QuadMesh& mesh, const Layout& layout,
                                                      const SharedEdges& shared);

} // namespace qm

/// \file Connected components of the faces: shells, and whether they are inside out.
#pragma once

#include "export/shared_edges.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <vector>

namespace qm {

/// A connected component of the faces.
struct BoundaryPart {
    std::vector<std::size_t> faces; ///< ascending
    bool closed = false;            ///< every edge has faces on both sides
    bool inward = false;            ///< closed, and its faces look inwards: all of them must be reversed
};

/// The components, ordered by their lowest face.
/// \param layout  one segment per face
/// \param shared  the edges of the faces
[[nodiscard]] std::vector<BoundaryPart> boundaryParts(const QuadMesh& mesh, const Layout& layout,
                                                      const SharedEdges& shared);

} // namespace qm

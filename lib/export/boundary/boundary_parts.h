/// \file Connected components of the faces: shells, which of them are cavities, and which are inside out.
#pragma once

#include "export/boundary/shared_edges.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A connected component of the faces.
struct BoundaryPart {
    std::vector<std::size_t> faces; ///< ascending
    bool closed = false;            ///< every edge has faces on both sides
    bool inward = false; ///< closed, and all of its faces must be reversed to look out of the solid
    std::optional<std::size_t> cavityOf{}; ///< the part around it, if this one is a cavity (see `Nesting`)
};

/// A solid with its cavities, or a shell.
struct BoundaryBody {
    const BoundaryPart* outer = nullptr;
    std::vector<const BoundaryPart*> cavities;
};

/// In the order of their outer parts.
/// \param parts  must outlive the bodies
[[nodiscard]] std::vector<BoundaryBody> bodiesOf(const std::vector<BoundaryPart>& parts);

/// The components, ordered by their lowest face.
/// \param layout  one segment per face
/// \param shared  the edges of the faces
[[nodiscard]] std::vector<BoundaryPart> boundaryParts(const QuadMesh& mesh, const Layout& layout,
                                                      const SharedEdges& shared);

} // namespace qm

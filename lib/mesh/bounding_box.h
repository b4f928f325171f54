/// \file The size of a mesh.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm {

/// The smallest box along the axes that holds all vertices that a face uses.
struct BoundingBox {
    Point low{0, 0, 0};
    Point high{0, 0, 0};

    [[nodiscard]] Point size() const { return high - low; }
    [[nodiscard]] double diagonal() const { return size().norm(); }
};

[[nodiscard]] BoundingBox boundingBox(const QuadMesh& mesh);

} // namespace qm

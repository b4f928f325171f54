/// \file The bounding box of a mesh.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm {

/// The smallest axis-parallel box that contains all vertices used by faces.
struct BoundingBox {
    Point low{0, 0, 0};
    Point high{0, 0, 0};

    [[nodiscard]] Point size() const { return high - low; }
    [[nodiscard]] double diagonal() const { return size().norm(); }
};

[[nodiscard]] BoundingBox boundingBox(const QuadMesh& mesh);

} // namespace qm

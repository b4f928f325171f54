/// \file The size of a mesh.
#pragma once

#include "mesh/quad_mesh.h"

namespace qm {

/// Length of the diagonal of the bounding box of all vertices that a face uses.
[[nodiscard]] double boundingBoxDiagonal(const QuadMesh& mesh);

} // namespace qm

/// \file Writing a quad mesh.
#pragma once

#include "mesh/quad_mesh.h"

#include <string>

namespace qm {

/// Text of an OBJ file with the mesh's numbering, faces with their first vertex first. Coordinates have the
/// fewest digits that read back exactly.
[[nodiscard]] std::string writeObj(const QuadMesh& mesh);

} // namespace qm

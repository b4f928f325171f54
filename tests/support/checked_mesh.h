/// \file Conversion of a mesh to the checker's own type.
#pragma once

#include "check/mesh/neighbourhoods.h"
#include "mesh/quad_mesh.h"

namespace qm::test {

[[nodiscard]] check::CheckedMesh checkedMesh(const QuadMesh& mesh);

} // namespace qm::test

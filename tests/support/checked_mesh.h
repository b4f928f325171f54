/// \file A mesh as the checker sees it.
#pragma once

#include "check/neighbourhoods.h"
#include "mesh/quad_mesh.h"

namespace qm::testing {

[[nodiscard]] check::CheckedMesh checkedMesh(const QuadMesh& mesh);

} // namespace qm::testing

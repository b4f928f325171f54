/// \file Moves the vertices of folded quads so that surfaces need not follow the folds
/// (docs/METHOD.md#reference).
#pragma once

#include "mesh/quad_mesh.h"

#include <optional>
#include <vector>

namespace qm {

/// Moves the vertices of folded quads (see `isFolded`), and if necessary those around them, to where the
/// smoothest continuation of their surroundings has them, so that fewer quads are folded. Vertices on
/// creases, on the boundary and of very many quads stay, as do those where folded quads may hide a crease.
/// Linear in the mesh.
/// \param isCrease  by edge; ignored beside folded quads
/// \return nothing if no vertex moves
[[nodiscard]] std::optional<QuadMesh> bridgedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease);

} // namespace qm

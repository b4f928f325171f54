/// \file Folded quads of a mesh drawn upright, so that surfaces need not follow them
/// (docs/METHOD.md#reference).
#pragma once

#include "mesh/quad_mesh.h"

#include <optional>
#include <vector>

namespace qm {

/// The same mesh with the vertices of folded quads (see `isFolded`), and if need be those around them, where
/// the smoothest continuation of what surrounds them has them, so that fewer quads are folded. Vertices of
/// creases and of the boundary stay, and those where folded quads may hide a crease. Linear in the mesh.
/// \param isCrease  by edge; beside folded quads it is not believed
/// \return nothing if no vertex moves
[[nodiscard]] std::optional<QuadMesh> bridgedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease);

} // namespace qm

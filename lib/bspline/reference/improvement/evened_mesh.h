/// \file Evens out the quads of plane parts, whose vertices may lie anywhere in their planes
/// (docs/METHOD.md#reference).
#pragma once

#include "mesh/quad_mesh.h"

#include <optional>
#include <vector>

namespace qm {

/// Remeshers make quads of plane parts as they can, with lines that turn sharply. Surfaces need not follow
/// these turns: where plane parts have any, the vertices move within the plane to where the smoothest
/// continuation of the part's outermost two rings of vertices has them. These rings, creases and vertices of
/// very many quads stay, as does every part in which quads would be turned over by it. Linear in the mesh but
/// for the factorisation of each part's equations.
/// \param isCrease  by edge, and the boundary
/// \param flatness  largest distance of vertices from the plane of a plane part
/// \return nothing if no vertex moves
[[nodiscard]] std::optional<QuadMesh> evenedMesh(const QuadMesh& mesh, const std::vector<bool>& isCrease,
                                                 double flatness, unsigned jobs);

} // namespace qm

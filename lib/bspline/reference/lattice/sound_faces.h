/// \file Quads over which surfaces need not fold, even where interpolation makes the reference fold.
#pragma once

#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Cosine of the angle between the normals in the middle and at a corner of a nearly flat quad: 20 degrees.
constexpr double nearlyFlat = 0.94;

/// The same of quads that are not folded: 78 degrees.
constexpr double notFolded = 0.2;

/// By face: whether it is not folded itself, nor turned over against a face beside it, nor turned by more
/// than a right angle from one that it should meet smoothly, and no face around it is without area.
/// \param sharp  by edge
[[nodiscard]] std::vector<bool> uprightFaces(const QuadMesh& mesh, const std::vector<bool>& sharp,
                                             unsigned jobs);

/// By face: whether it is flat within an angle, nearly if not told otherwise, and convex, and no face around
/// it is folded. Surfaces can be upright over such faces even where interpolation makes the reference fold.
/// \param minCosine  of the angle between the normals in the middle and at any corner
[[nodiscard]] std::vector<bool> soundFaces(const QuadMesh& mesh, unsigned jobs,
                                           double minCosine = nearlyFlat);

/// Takes out the faces within so many rings around those that are not among them.
[[nodiscard]] std::vector<bool> shrunk(const QuadMesh& mesh, std::vector<bool> faces, int rings);

/// By vertex: whether all faces around it are sound.
[[nodiscard]] std::vector<bool> soundVertices(const QuadMesh& mesh, unsigned jobs,
                                              double minCosine = nearlyFlat);

} // namespace qm

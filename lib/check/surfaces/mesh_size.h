/// \file How large a mesh is, and what rounding may do to its coordinates.
#pragma once

#include "check/mesh/neighbourhoods.h"

namespace qm::check {

/// The length of the diagonal of the bounding box of all quads; 0 without quads.
[[nodiscard]] double boundingBoxDiagonal(const CheckedMesh& mesh);

/// How far apart two points may be that should be the same: 1e-9 of the diagonal, and the rounding of
/// coordinates far from the origin.
[[nodiscard]] double samePlace(const CheckedMesh& mesh);

} // namespace qm::check

/// \file How stiff surfaces are above each quad (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/reference/reference_grid.h"

#include <array>
#include <vector>

namespace qm {

/// Weights of the squared second derivatives by the parameters, beside those of squared distances, which are
/// 1 a quad.
struct ThinPlate {
    double uu = 0;
    double uv = 0; ///< of the mixed one, which the energy has twice
    double vv = 0;
};

/// The bending of plates of the quads' own shape, so much that surfaces which could turn less by a radian
/// within a quad are about a third of the tolerance away for it. By quad, row by row.
[[nodiscard]] std::vector<ThinPlate> thinPlates(const ReferenceGrid& reference, double tolerance);

/// Plates that give way to any error, where those above keep surfaces from following the reference.
/// \param size  quads along u and v
[[nodiscard]] std::vector<ThinPlate> softPlates(const std::array<int, 2>& size);

} // namespace qm

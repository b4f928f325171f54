/// \file The bending stiffness of a surface above each quad (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/reference/lattice/reference_grid.h"

#include <array>
#include <vector>

namespace qm {

/// Weights of the squared second derivatives by the parameters, relative to squared distances, which have a
/// weight of 1 per quad.
struct ThinPlate {
    double uu = 0;
    double uv = 0; ///< of the mixed derivative, which the energy contains twice
    double vv = 0;
};

/// The stiffness of plates with the quads' own shape, by quad, row by row: if a surface can turn by a radian
/// less within a quad, it may be about half of the tolerance farther away for it, and a third of the
/// tolerance where the quad is not stiff.
/// \param isStiff  by quad
[[nodiscard]] std::vector<ThinPlate> thinPlates(const ReferenceGrid& reference,
                                                const std::vector<bool>& isStiff, double tolerance);

/// Plates that yield to any error, for patches where the ones above prevent the surface from following the
/// reference.
/// \param size  quads along u and v
[[nodiscard]] std::vector<ThinPlate> softPlates(const std::array<int, 2>& size);

} // namespace qm

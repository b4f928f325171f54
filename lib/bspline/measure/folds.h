/// \file Finds the folds of a patch, certified by the Bezier points of its normal.
#pragma once

#include "bspline/reference/lattice/reference_grid.h"
#include "bspline/splines/surfaces.h"

#include <vector>

namespace qm {

/// Finds where the normal of a patch vanishes or turns over against that of its reference, or against that of
/// the mesh's quad where the reference itself turns over: one place (u, v) for every piece between knots that
/// may be folded. A piece is certain not to be if the Bezier points of du x dv, of degrees 2p - 1 and 2q - 1,
/// all point to the side of that normal at its middle. Otherwise it is divided into quarters, down to 1/32 of
/// its sides. No fold is missed; a false one may be reported where the normals are nearly at right angles.
[[nodiscard]] std::vector<Parameters> findFolds(const Patch& patch, const ReferenceGrid& reference);

} // namespace qm

/// \file Does a patch fold? Certified by the Bezier points of its normal.
#pragma once

#include "bspline/reference/reference_grid.h"
#include "bspline/splines/surfaces.h"

#include <array>
#include <vector>

namespace qm {

/// Where the normal of a patch vanishes or turns over against that of its reference, or of the mesh's quad
/// where the reference turns over against it: u and v, one place for every piece between knots that is not
/// certain to be free of it. A piece is certain if the Bezier points of du x dv, which has degrees 2p - 1 and
/// 2q - 1, all point to the side of that normal at its middle. If not, its quarters are looked at, and
/// theirs, down to 1/32 of its sides. No fold is missed; a false one may be reported where the normals are
/// nearly at right angles.
[[nodiscard]] std::vector<std::array<double, 2>> findFolds(const Patch& patch,
                                                           const ReferenceGrid& reference);

} // namespace qm

/// \file Edges that lie off the surfaces of their faces.
#pragma once

#include "export/boundary/boundary.h"

namespace qm {

/// Divides edges that are farther than the resolution from a face's surface where they are farthest away.
/// Files hold no tolerances: whoever reads one measures an edge's distance from its faces at the ends and at
/// some points between, and trusts the largest. If the true one is only slightly larger, cuts through the
/// edge fail. At an end it is not missed. An edge stays whole if one part would be hardly longer than the
/// distance.
/// \return whether there was one
bool divideLooseEdges(Boundary& boundary);

} // namespace qm

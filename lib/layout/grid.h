/// \file From a region with four corners to a segment (docs/METHOD.md#layout).
#pragma once

#include "layout/layout.h"
#include "layout/region.h"

namespace qm {

/// Lays the region's faces out row by row. The first corner is the one with the lowest vertex, of equal ones
/// that with the lowest face, so that equal regions give equal segments.
/// \param region  with one border loop
/// \throw Error  naming a vertex, if the region is not a grid with four corners
[[nodiscard]] Segment makeSegment(const QuadMesh& mesh, const Region& region);

} // namespace qm

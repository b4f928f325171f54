/// \file Turning a region with four corners into a segment (docs/METHOD.md#layout).
#pragma once

#include "layout/layout.h"
#include "layout/region.h"

namespace qm {

/// Arranges the region's faces in rows. The first corner is the one with the lowest vertex, and among equal
/// vertices the one with the lowest face, so that equal regions give equal segments.
/// \param region  has one border loop
/// \throw Error  naming a vertex, if the region is not a grid with four corners
[[nodiscard]] Segment makeSegment(const QuadMesh& mesh, const Region& region);

} // namespace qm

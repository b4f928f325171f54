/// \file Are these B-spline surfaces, and do they keep what their fit has promised?
/// (docs/METHOD.md#smooth-fit)
#pragma once

#include "check/checked_document.h"
#include "check/neighbourhoods.h"
#include "check/report.h"

namespace qm::check {

/// One patch per segment, in their order, with sound knots whose domain is the segment's grid, and finite
/// control points. An interpolating fit passes through every vertex within 1e-9 of the bounding box's
/// diagonal. Neighbours of a smooth fit agree along their borders within the same.
///
/// \param layout  must have passed its own check
void checkSurfaces(const CheckedMesh& mesh, const Neighbourhoods& around, const LayoutPart& layout,
                   const SurfacesPart& part, Report& report);

} // namespace qm::check

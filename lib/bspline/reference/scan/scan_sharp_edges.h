/// \file Targets at sharp edges, which a scan has rounded or frayed (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/scan/scan_targets.h"

namespace qm {

/// Moves sharp points to where their sides, extended, meet, unless that is farther from the scan than they
/// are already by more than noise explains: then the sides are curved, and the nearest point of the scan is
/// better.
/// \param maxDistance  largest distance at which that point is looked for
/// \param maxRounding  largest distance of a scan's edge from the sharp one
void extrapolateToSharpEdges(ScanTargets& targets, const TriangleSurface& scan, double maxDistance,
                             double maxRounding);

} // namespace qm

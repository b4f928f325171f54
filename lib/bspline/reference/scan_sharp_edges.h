/// \file Targets at sharp edges, which a scan has rounded or frayed (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/scan_targets.h"

namespace qm {

/// Sharp points go where their sides, carried on, meet, unless that is farther from the scan than they are
/// already, beyond what noise explains: then the sides bend, and the nearest point of the scan is better.
/// \param maxDistance  to look for that point at most
/// \param maxRounding  how far at most a scan's edge is from the sharp one
void carryOnToSharpEdges(ScanTargets& targets, const TriangleSurface& scan, double maxDistance,
                         double maxRounding);

} // namespace qm

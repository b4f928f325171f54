/// \file Points along the borders where patches meet smoothly.
#pragma once

#include "export/boundary/shared_edges.h"
#include "export/simple/smooth_borders.h"

#include <vector>

namespace qm {

/// \param smoothAngle  normals of smooth neighbours differ by less, in degrees
[[nodiscard]] std::vector<SmoothBorder> smoothBorders(const std::vector<Patch>& clampedPatches,
                                                      const SharedEdges& shared, double smoothAngle);

} // namespace qm

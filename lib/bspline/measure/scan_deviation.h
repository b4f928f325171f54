/// \file The largest distance of surfaces from a scan, certain to within a few per cent where possible.
#pragma once

#include "bspline/measure/certified_deviation.h"
#include "bspline/reference/scan/triangle_surface.h"
#include "bspline/splines/surfaces.h"

#include <vector>

namespace qm {

/// Branch and bound over the Bezier pieces of the patches: the distance from a triangle is a convex function,
/// so a piece is no farther from it than the farthest of its Bezier points. Places whose nearest point lies
/// on the scan's boundary or beyond the cut-off do not count.
/// \param cutOff  distance beyond which the scan tells nothing about the surface
[[nodiscard]] ScanDeviations deviationFromScan(const std::vector<Patch>& patches, const TriangleSurface& scan,
                                               double cutOff, const CertificationOptions& options,
                                               unsigned jobs);

} // namespace qm

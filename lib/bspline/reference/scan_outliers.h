/// \file Targets that jump out from those around them (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/scan_targets.h"

namespace qm {

/// Measures the noise, and weighs every target by Tukey's biweight of its distance from the median of those
/// around it; what is usual in a rough place is no outlier.
/// \param step  a length below which differences between neighbours are no sign of an outlier
void weighOutliers(ScanTargets& targets, double step);

/// A sharp point that jumps out from its neighbours along the edge has no target.
/// \param step  as above; the noise must have been measured
void dropSharpOutliers(ScanTargets& targets, double step);

} // namespace qm

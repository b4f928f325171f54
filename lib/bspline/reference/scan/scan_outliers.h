/// \file Detects targets that stand out from those around them (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/scan/scan_targets.h"

namespace qm {

/// Measures the noise, and weights every target by Tukey's biweight of its distance from the median of its
/// neighbours. Distances that are usual in a rough place do not make an outlier.
/// \param step  differences between neighbours below this length do not indicate an outlier
void weighOutliers(ScanTargets& targets, double step);

/// Removes the targets of sharp points that stand out from their neighbours along the edge.
/// \param step  as above; the noise must have been measured
void dropSharpOutliers(ScanTargets& targets, double step);

} // namespace qm

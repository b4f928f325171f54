/// \file Detects targets that stand out from those around them (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/scan/scan_targets.h"

namespace qm {

/// The noise, as far as the offsets of targets tell it: where they lie near the surface, as they do if the
/// mesh's vertices were taken from a scan as coarse as the mesh, it comes out too small.
[[nodiscard]] double noiseOfTargets(const ScanTargets& targets);

/// Weights every target by Tukey's biweight of its distance from the median of its
/// neighbours. Distances that are usual in a rough place do not make an outlier.
/// \param targets  their noise must be known
/// \param step     differences between neighbours below this length do not indicate an outlier
void weighOutliers(ScanTargets& targets, double step);

/// Removes the targets of sharp points that stand out from their neighbours along the edge.
/// \param step  as above; the noise must be known
void dropSharpOutliers(ScanTargets& targets, double step);

} // namespace qm

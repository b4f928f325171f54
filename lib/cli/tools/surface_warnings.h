/// \file Warnings about defects of surfaces, on standard error.
#pragma once

#include "bspline/splines/surfaces.h"

namespace qm {

class Tool;

/// Warns if patches are farther apart than the distance within which STEP identifies points.
void warnOfGaps(const Tool& tool, const Surfaces& surfaces);

/// Warns if patches may fold over: how many pieces of them, and where in the patch with the most.
void warnOfFolds(const Tool& tool, const Surfaces& surfaces);

/// Warns if the scan shows so little of the mesh that it may be another part, or lie elsewhere.
void warnOfCoverage(const Tool& tool, const Surfaces& surfaces);

/// Warns if surfaces fitted to a mesh leave one of its vertices by more than a distance, because the quads
/// around are folded (docs/METHOD.md#reference): how far, and in which patch.
void warnOfBridges(const Tool& tool, const Surfaces& surfaces, double allowed);

} // namespace qm

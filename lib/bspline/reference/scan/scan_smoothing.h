/// \file Removes the scan's noise from the targets.
#pragma once

#include "bspline/reference/lattice/fit_target.h"

namespace qm {

/// Moves every target onto a cubic fitted to the targets around it along the lines of the lattice, in both
/// directions (Savitzky and Golay's filter with the targets' weights, docs/METHOD.md#savitzky-1964). The
/// number of targets is chosen for each point: as large as possible while the change is explained by the
/// noise (Lepski's rule, docs/METHOD.md#lepski-1991), so that details above the noise are kept. Border lines
/// stay. Does nothing without noise.
/// \param reference  its `noise` is the expected standard deviation
/// \param grain      so many neighbours have nearly the same noise; 1 if each has its own
void smoothInside(FitTarget& reference, double grain, unsigned jobs);

/// The same for border lines, only along them, so that neighbours still agree there and creases stay sharp.
void smoothBorders(FitTarget& reference, double grain, unsigned jobs);

} // namespace qm

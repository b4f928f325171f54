/// \file Taking a scan's noise off the targets that it gives.
#pragma once

#include "bspline/reference/scan_reference.h"

namespace qm {

/// Draws a cubic through the targets around each one, along the lines of the lattice in both directions
/// (Savitzky and Golay's filter with the targets' weights, docs/METHOD.md#savitzky-1964), and puts the target
/// on it. How many take part is chosen point by point: more, as long as that changes the target by no more
/// than the noise explains (Lepski's rule, docs/METHOD.md#lepski-1991), so that what is no noise stays.
/// Border lines stay. Does nothing where there is no noise to speak of.
/// \param reference  its `noise` is the standard deviation to be expected
void smoothInside(ScanReference& reference, unsigned jobs);

/// The same for border lines: along themselves only, so that neighbours still agree there and creases stay
/// sharp.
void smoothBorders(ScanReference& reference, unsigned jobs);

} // namespace qm

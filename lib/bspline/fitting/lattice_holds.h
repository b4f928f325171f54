/// \file Points of a lattice that may not slide, because sliding has led astray there.
#pragma once

#include "bspline/fitting/fit_lattice.h"

#include <array>
#include <vector>

namespace qm {

/// Holds all points no farther than a mesh edge, along u and v, from points where the patch is folded: once
/// for each of these.
/// \param isFolded  by point
void holdAroundFolds(const std::vector<bool>& isFolded, FitLattice& lattice);

/// Holds points in a rectangle of parameters for good.
/// \return false if all of them were held for good already
bool holdTargets(const std::array<double, 2>& begin, const std::array<double, 2>& end, FitLattice& lattice);

/// Lets points slide again that were not held too often.
void releaseHolds(FitLattice& lattice);

} // namespace qm

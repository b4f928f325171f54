/// \file Lattice points whose targets may not slide, because sliding has led to folds or misses there.
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"
#include "bspline/fitting/lattice/lattice_cells.h"

#include <vector>

namespace qm {

/// Holds all points within one mesh edge, along u and v, of a folded point; a point's hold count grows by one
/// for each folded point near it.
/// \param isFolded  by point
void holdAroundFolds(const std::vector<bool>& isFolded, FitLattice& lattice);

/// Holds all points in rectangles of parameters for good.
/// \return false if all of them were held for good already
bool holdTargets(const std::vector<KnotCell>& rectangles, FitLattice& lattice);

/// Releases all points that have been held fewer than `maxHolds` times.
void releaseHolds(FitLattice& lattice);

} // namespace qm

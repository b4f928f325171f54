/// \file Normals of the reference where it folds (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"

namespace qm {

/// Where the reference folds over a sound quad, replaces its normals by those of the quad, which keeps the
/// patch upright, and marks its points as guesses. Elsewhere forgets normals on both sides of a fold: patches
/// need not be free of folds there.
/// \param lattice  has the reference's points, normals and Jacobians; the marks are allocated
void mendFoldedNormals(const LatticeSource& source, FitLattice& lattice);

} // namespace qm

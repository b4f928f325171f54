/// \file Quads over which the reference folds although the mesh does not (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/lattice/fit_lattice.h"

namespace qm {

/// Where the reference folds over a sound quad, replaces its normals by those of the quad, which keeps the
/// patch upright, and marks its points as guesses.
/// \param lattice  has the reference's points, normals and Jacobians; the marks are allocated
void replaceFoldedNormals(const LatticeSource& source, FitLattice& lattice);

} // namespace qm

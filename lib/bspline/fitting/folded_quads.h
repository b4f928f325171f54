/// \file Quads over which the reference folds although the mesh does not (docs/METHOD.md#smooth-fit).
#pragma once

#include "bspline/fitting/fit_lattice.h"

namespace qm {

/// Where the reference folds over a sound quad its normals become those of the quad, to keep patches upright,
/// and its points are marked as guesses.
/// \param lattice  has the reference's points, normals and Jacobians, and room for marks
void unfoldQuads(const LatticeSource& source, FitLattice& lattice);

} // namespace qm

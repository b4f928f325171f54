/// \file Drops targets over which a surface would fold.
#pragma once

#include "bspline/reference/lattice/fit_target.h"
#include "bspline/reference/lattice/lattice_normals.h"

namespace qm {

/// If a cell of the lattice turns over at a corner when its points move to their targets, these belong to
/// another part of the scan, such as the far side of a sharp edge that no line of the mesh follows. They
/// return to the surface and get a weight of 0.
/// \param surface  the surface that `lattice` and `reference` were made from
void dropFolded(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface,
                FitTarget& reference);

} // namespace qm

/// \file Fills in targets where a scan shows nothing.
#pragma once

#include "bspline/reference/lattice/fit_target.h"
#include "bspline/reference/lattice/lattice_normals.h"

namespace qm {

enum class Gaps { butForSharpOnes, all };

/// Where a target has a weight below one half, in holes of the scan and at outliers, it gets a displacement
/// and a small weight: the displacements there solve Laplace's equation on the lattice, so that nothing jumps
/// where a hole begins. A part of the surface that the scan is nowhere near stays as it is.
/// \param surface  the surface that `lattice` and `reference` were made from
/// \param gaps     whether sharp points are filled in as well; otherwise they are not used
void fillGaps(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface, Gaps gaps,
              FitTarget& reference);

} // namespace qm

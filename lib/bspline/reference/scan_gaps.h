/// \file Targets where a scan shows nothing.
#pragma once

#include "bspline/reference/lattice_normals.h"
#include "bspline/reference/scan_reference.h"

namespace qm {

enum class Gaps { butForSharpOnes, all };

/// Where a target weighs less than half, in holes of the scan and at outliers, the surface takes over the
/// displacements of the targets around: the values in between solve Laplace's equation on the lattice. So
/// nothing jumps where a hole begins. A part that the scan shows nowhere near stays as it is. Filled targets
/// get a small weight.
/// \param surface  that `lattice` and `reference` were made from
/// \param gaps  whether sharp points are filled in, too; else they are not looked at
void fillGaps(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface, Gaps gaps,
              ScanReference& reference);

} // namespace qm

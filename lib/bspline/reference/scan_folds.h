/// \file Targets over which a surface would fold.
#pragma once

#include "bspline/reference/lattice_normals.h"
#include "bspline/reference/scan_reference.h"

namespace qm {

/// Where a cell of the lattice turns over at a corner when its points move to their targets, these show
/// something else than the surface, such as the far side of a sharp edge that no line of the mesh follows:
/// they go back to the surface and weigh nothing.
/// \param surface  that `lattice` and `reference` were made from
void dropFolded(const LatticeNormals& lattice, const std::vector<ReferenceGrid>& surface,
                ScanReference& reference);

} // namespace qm

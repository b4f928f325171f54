/// \file Takes folds out of the limit surface where the mesh has none.
#pragma once

#include "bspline/reference/mesh_lattice.h"

#include <vector>

namespace qm {

/// Where the surface folds over a sound quad (see `soundFaces`) of a plane region, as interpolation may where
/// quads of very different shape meet, it becomes that quad between its border curves; a border with another
/// sound quad that is not sharp becomes straight, and what lies beside it goes along. Linear in the mesh.
/// \param sharp  by edge: its curve stays
void unfold(MeshLattice& lattice, const std::vector<bool>& sharp, unsigned jobs);

} // namespace qm

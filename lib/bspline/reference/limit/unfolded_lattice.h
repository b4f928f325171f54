/// \file Removes folds of the limit surface over quads that are not folded.
#pragma once

#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// Where the surface folds over a sound quad (see `soundFaces`), as interpolation can where quads of very
/// different shape meet, it is replaced by that quad between its border curves. Curves that it shares with
/// other sound quads are replaced by curves determined by their ends alone (see `EdgeCurves`), sharp ones
/// only where they turn back, and the surface beside them follows. Linear in the mesh.
/// \param sharp  by edge
void unfold(MeshLattice& lattice, const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
            unsigned jobs);

} // namespace qm

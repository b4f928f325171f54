/// \file Takes folds out of the limit surface where the mesh has none.
#pragma once

#include "bspline/reference/mesh_lattice.h"

#include <vector>

namespace qm {

/// Where the surface folds over a sound quad (see `soundFaces`), as interpolation may where quads of very
/// different shape meet, it becomes that quad between its border curves. Those that it shares with other
/// sound quads become curves that their ends alone decide (see `EdgeCurves`), sharp ones only where they turn
/// back, and what lies beside them goes along. Linear in the mesh.
/// \param sharp  by edge
void unfold(MeshLattice& lattice, const std::vector<VertexRule>& rules, const std::vector<bool>& sharp,
            unsigned jobs);

} // namespace qm

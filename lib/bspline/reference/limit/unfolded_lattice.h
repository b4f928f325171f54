/// \file Removes folds of the reference over quads that are not folded.
#pragma once

#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/limit/fold_test.h"
#include "bspline/reference/planes/plane_corners.h"

#include <vector>

namespace qm {

/// Where the surface folds over an upright quad (see `uprightFaces`), as interpolation can where quads of
/// very different shape meet, it is replaced by that quad between its border curves. Curves that it shares
/// with other upright quads are replaced by curves determined by their ends alone (see `EdgeCurves`), sharp
/// ones only where they turn back, and the surface beside them follows. While it still folds, all its curves
/// move halfway to the quad's edges, twice, and then become these edges. Linear in the mesh.
/// \param corners  whose planes the surface stays tangent to; null if it is tangent to none yet
/// \param limits   what counts as a fold
void unfold(MeshLattice& lattice, const Sharpness& sharpness, const PlaneCorners* corners,
            const FoldLimits& limits, unsigned jobs);

} // namespace qm

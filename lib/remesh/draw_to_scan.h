/// \file A quad mesh drawn closer to the scan that it was made of (docs/METHOD.md#drawing).
#pragma once

#include "mesh/quad_mesh.h"
#include "mesh/triangles/triangles.h"

namespace qm {

/// Moves the vertices so that the distances of the quads from the scan and of the scan from the quads become
/// small, in the sense of robust least squares. So the sharp edges and corners come back that a remesher cuts
/// off by quads that lie across them: the nearest rows of vertices move there. At first the quads are made
/// even, which unfolds most of those that are folded; later, neighbours only move alike where the scan says
/// nothing else. Quads that are folded after that are unfolded one vertex at a time.
/// \param mesh  nearer to the scan than about an edge, and oriented like it
/// \param jobs  threads; the result does not depend on it
[[nodiscard]] QuadMesh drawToScan(QuadMesh mesh, const Triangles& scan, unsigned jobs);

} // namespace qm

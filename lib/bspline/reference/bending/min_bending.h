/// \file Tilts tangent planes so that the surface through a mesh's vertices bends least
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/planes/plane_corners.h"

#include <vector>

namespace qm {

/// Tilts the tangent planes at smooth vertices all of whose quads are sound (see `soundFaces`) and that no
/// plane part binds, and twists the surface at regular ones of these, so that it bends least in space; the
/// vertices stay. A spline with uniform parameters takes mesh lines for straight, and waves where they turn,
/// as around extraordinary vertices. Linear in the mesh.
void minimiseBending(MeshLattice& lattice, const std::vector<VertexRule>& rules, const PlaneCorners& corners,
                     unsigned jobs);

} // namespace qm

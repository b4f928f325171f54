/// \file Tangent planes with which the surface through a mesh's vertices bends least
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/mesh_lattice.h"

#include <vector>

namespace qm {

/// Tilts the surface's tangent planes at smooth vertices around which all quads are sound (see `soundFaces`),
/// such that it bends least in space; the vertices stay. A spline of uniform parameters takes the lines of a
/// mesh for straight and evenly divided: where they turn, as around extraordinary vertices, it waves. Linear
/// in the mesh.
void bendLeast(MeshLattice& lattice, const std::vector<VertexRule>& rules, unsigned jobs);

} // namespace qm

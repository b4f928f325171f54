/// \file Rounds a limit surface off at vertices of many edges (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// Subdivision draws a cone with a blunt tip around a vertex of many edges. Here the surface becomes tangent
/// to a plane at each pole, a smooth interior vertex of eight edges or more, leaves it along every edge as
/// evenly as it advances over the edge, and gets the mixed derivatives with which the quads around are
/// tangent to one another near it. Vertices stay, and so does everything beyond the quads around poles.
/// Linear in the mesh.
void evenPoles(MeshLattice& lattice, const std::vector<VertexRule>& rules, unsigned jobs);

} // namespace qm

/// \file Lays the surface above plane parts of a mesh into their planes (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/planes/plane_corners.h"

#include <vector>

namespace qm {

/// Moves the surface above the quads of plane parts into their planes, along their normals; surfaces smoothly
/// beside them follow, so that they are tangent to the planes. Vertices stay: where they are off their plane,
/// by roundings, the surface is too. Linear in the mesh.
/// \param isCrease  by edge, and the boundary
void layInPlanes(MeshLattice& lattice, const PlaneCorners& corners, const std::vector<bool>& isCrease,
                 unsigned jobs);

} // namespace qm

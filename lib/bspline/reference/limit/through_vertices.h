/// \file Makes a lattice pass through the vertices of its mesh.
#pragma once

#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// Moves every vertex of the lattice to where the mesh has it. Where the limit of the control mesh is
/// elsewhere, the points of the quads around follow by cubic weights that are flat at vertices and edges, so
/// the surface keeps its tangent planes at vertices, and is smooth across edges wherever both sides have one
/// parameterisation.
/// \param interpolates  by vertex: whether the lattice passes through it but for rounding, and nothing around
///                      has to follow
void drawThroughVertices(MeshLattice& lattice, const std::vector<bool>& interpolates, unsigned jobs);

} // namespace qm

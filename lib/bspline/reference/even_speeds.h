/// \file Makes the parameters of a limit surface run evenly along mesh lines with uneven edges
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/reference/mesh_lattice.h"

namespace qm {

/// A spline with uniform parameters leaves a vertex along both edges of a line at the same speed, although
/// one may be much shorter than the other, and so waves along both. Here the surface leaves each vertex along
/// each edge at the speed of an arc between the edge's ends; vertices and tangent planes stay. Nothing
/// changes at extraordinary vertices, and where a quad is not sound (see `soundFaces`). Linear in the mesh.
void evenSpeeds(MeshLattice& lattice, unsigned jobs);

} // namespace qm

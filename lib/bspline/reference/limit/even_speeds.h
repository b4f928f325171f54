/// \file Makes the parameters of a limit surface run evenly along mesh lines with uneven edges
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/planes/plane_corners.h"

#include <vector>

namespace qm {

/// A spline with uniform parameters leaves a vertex along both edges of a line at the same speed, although
/// one may be much shorter than the other, and so waves along both. Here the surface leaves each vertex along
/// each edge at the speed of an arc between the edge's ends, but no faster than a much shorter edge before it
/// on the same line allows, and along creases in the direction that the lengths of edges demand (see
/// `creaseDirections`), within the planes that bind it; vertices stay, and so do tangent planes but at
/// creases. Nothing changes at extraordinary vertices, and where a quad is folded; directions change only
/// where all quads are sound (see `soundFaces`). Linear in the mesh.
void evenSpeeds(MeshLattice& lattice, const std::vector<VertexRule>& rules, const PlaneCorners& corners,
                unsigned jobs);

} // namespace qm

/// \file Makes the parameters of a limit surface run evenly along mesh lines with uneven edges
/// (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"
#include "bspline/reference/planes/plane_corners.h"

#include <vector>

namespace qm {

/// Where an edge is much longer than the one before it on the same line, the surface leaves along it no
/// faster than so many times the short one's length: splines cannot change their speed at once, and would
/// turn back.
constexpr double maxSpeedUp = 3;

/// A spline with uniform parameters leaves a vertex along both edges of a line at the same speed, although
/// one may be much shorter than the other, and so waves along both. Here the surface leaves each vertex along
/// each edge at the speed of an arc between the edge's ends, but no faster than a much shorter edge before it
/// on the same line allows, and along creases in the direction that the lengths of edges demand (see
/// `creaseDirections`), within the planes that bind it. Near their ends lines also turn as parabolas do (see
/// `parabolicEnds`). Vertices stay, and so do tangent planes elsewhere. Speeds change little at extraordinary
/// vertices, and not where a quad is folded; directions only where all quads are sound (see `soundFaces`).
/// Linear in the mesh.
void evenSpeeds(MeshLattice& lattice, const Sharpness& sharpness, const PlaneCorners& corners, unsigned jobs);

} // namespace qm

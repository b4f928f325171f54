/// \file The smooth surface through the vertices of a mesh, which is the reference if there is no scan.
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/reference_grid.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The limit of Catmull-Clark subdivision that interpolates the mesh's vertices, with creases at given edges,
/// and corners where the rules have them; components without such a limit are drawn through their vertices
/// (see `interpolatingControlMesh`, `drawThroughVertices`). It keeps its curvature up to creases (see
/// `parabolicEnds`). It is plane over plane parts of the mesh, and tangent to them beside (see
/// `layInPlanes`). Its tangent planes at smooth vertices are tilted so that it waves less (see
/// `minimiseBending`). Segments have bitwise equal lattice points on their common borders. Lattice points at
/// vertices equal the vertices. Over quads that are not folded, the surface is not either (see `unfold`).
/// Linear in the mesh.
/// \param steps  lattice steps per quad: a power of two, at least 2
/// \param jobs   threads; the result does not depend on their number
/// \return by segment: its part of the surface
[[nodiscard]] std::vector<ReferenceGrid> limitSurface(const QuadMesh& mesh, const Layout& layout,
                                                      const Sharpness& sharpness, int steps, unsigned jobs);

} // namespace qm

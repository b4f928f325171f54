/// \file The smooth surface through the vertices of a mesh: the reference where there is no scan.
#pragma once

#include "bspline/reference/reference_grid.h"
#include "layout/layout.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// The limit of Catmull-Clark subdivision that interpolates the mesh's vertices, with creases at the given
/// edges and at the mesh boundary; `vertexRules` says where it has corners. Its tangent planes at smooth
/// vertices are tilted so that it waves less (see `bendLeast`). Lattice points on a common border
/// of segments are the same to the last bit in both, and those at vertices are the vertices themselves, but
/// for components without an interpolating limit (see `interpolatingControlMesh`). It does not fold over
/// sound quads (see `unfold`). In time linear in the mesh.
/// \param isCrease  by edge
/// \param steps  lattice steps a quad: a power of two, at least 2
/// \param jobs  threads; the result does not depend on them
/// \return for every segment its part of the surface
[[nodiscard]] std::vector<ReferenceGrid> limitSurface(const QuadMesh& mesh, const Layout& layout,
                                                      const std::vector<bool>& isCrease, int steps,
                                                      unsigned jobs);

} // namespace qm

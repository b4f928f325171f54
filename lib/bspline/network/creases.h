/// \file Which borders of a layout are creases.
#pragma once

#include "bspline/network/borders.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// Marks the borders, and which of them are creases: those with a dihedral angle above rho, and the mesh
/// boundary. That limit is corrected in five ways. First, where a coarse mesh bends as much beside a curve of
/// creases, the surface is round, and the curve becomes smooth (docs/METHOD.md#roundness). The others are
/// there because a surface that is cut for a while is neither sharp nor smooth, bends far too much where the
/// cut ends, and cannot be offset by CAD systems:
/// - what goes straight on from the loose end of a crease, or leaves a corner of creases, as far as another
///   crease, is one too if all its angles are more than half of rho (docs/METHOD.md#canny-1986) and the
///   surface is not round there;
/// - a curve of creases that ends in nothing, after a few edges or where the surface is somewhat round, and
///   nowhere sharp beyond doubt, is taken back as far as where creases meet;
/// - where just two creases meet at an angle, the sharpest border between them is a crease, too, if its
///   angle, or that between the corners of the quads beside it, is more than half of rho: surfaces that are
///   smooth on both sides of a corner have one tangent plane there, which no two faces that meet in an edge
///   have;
/// - where three or more meet, all borders are creases at which one of these angles is more than rho.
/// \param borders  of the layout
/// \param dihedralAngles  by edge index, radians
[[nodiscard]] BorderMarks markBorders(const QuadMesh& mesh, const std::vector<BorderEdge>& borders,
                                      const std::vector<double>& dihedralAngles, double rho);

} // namespace qm

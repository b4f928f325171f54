/// \file Which borders of a layout are creases.
#pragma once

#include "bspline/network/borders.h"
#include "mesh/quad_mesh.h"

#include <vector>

namespace qm {

/// By edge: the borders of larger dihedral angle than rho, without what is noise about that limit, and the
/// ends of the surface. A curve of creases that ends in nothing, after a few edges and nowhere sharp beyond
/// doubt, is taken back as far as where creases meet: a surface with such a cut is neither sharp nor smooth,
/// and CAD systems cannot offset it.
/// \param borders  of the layout
/// \param dihedralAngles  by edge index, radians
[[nodiscard]] std::vector<bool> findCreases(const QuadMesh& mesh, const std::vector<BorderEdge>& borders,
                                            const std::vector<double>& dihedralAngles, double rho);

} // namespace qm

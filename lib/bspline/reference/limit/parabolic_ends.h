/// \file Lines of a surface that keep their curvature where they end at creases (docs/METHOD.md#reference).
#pragma once

#include "bspline/network/vertex_rules.h"
#include "bspline/reference/lattice/mesh_lattice.h"

#include <vector>

namespace qm {

/// What is to be added to the derivative along a halfedge, at its beginning.
struct Turn {
    HalfedgeId leaving;
    Point by;
};

/// The lines of a subdivision surface have no curvature where they end: mesh lines at creases and at the
/// boundary, and creases at corners. Turned like this they end as parabolas do ("parabolic runout"), with no
/// third derivative in their last interval, and still have continuous second derivatives between; mesh lines
/// along the normal, creases in space. Mesh lines are turned only where no other one ends between the same
/// two creases, and creases between single quads, so that the surface stays smooth there. A halfedge may have
/// several turns. Linear in the mesh.
[[nodiscard]] std::vector<Turn> parabolicEnds(const MeshLattice& lattice, const Sharpness& sharpness);

} // namespace qm

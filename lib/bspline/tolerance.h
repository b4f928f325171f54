/// \file Patches with few control points within a tolerance of the mesh that share their borders exactly.
#pragma once

#include "bspline/surfaces.h"
#include "merge/layout.h"

#include <vector>

namespace qm {

/// First the curves of all chains of border edges, within half the tolerance, through every vertex where
/// borders meet; then every patch between its curves. \param tolerance  in the mesh's unit
[[nodiscard]] std::vector<Patch> fitWithinTolerance(const QuadMesh& mesh, const Layout& layout,
                                                    const std::vector<double>& dihedralAngles, double rho,
                                                    double tolerance, unsigned jobs);

} // namespace qm

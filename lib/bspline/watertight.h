/// \file Interpolating patches that share their borders (an alternative to the paper's free ends).
#pragma once

#include "bspline/curve_network.h"
#include "bspline/surfaces.h"
#include "layout/layout.h"

#include <span>

namespace qm {

/// The bicubic spline through a segment's (m + 1) x (n + 1) points that has the given sides: their curves and
/// the derivatives across them. (m + 3) x (n + 3) control points, knots clamped at the ends and else at the
/// integers; three more knots, and two more rows of points, at a joint of a side's pieces.
/// \param grid  row by row as in `vertexGrid`; the sides pass through its border
[[nodiscard]] Patch interpolateBetween(std::span<const Point> grid, const std::array<int, 2>& size,
                                       const std::array<SideCurves, 4>& sides);

/// For every segment. Linear in the mesh.
[[nodiscard]] std::vector<Patch> interpolateWatertight(const QuadMesh& mesh, const Layout& layout,
                                                       const std::vector<double>& dihedralAngles, double rho,
                                                       unsigned jobs);

} // namespace qm

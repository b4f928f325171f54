/// \file The paper's interpolation of a grid of points (docs/METHOD.md#interpolation).
#pragma once

#include "bspline/splines/surfaces.h"
#include "layout/layout.h"

#include <array>
#include <span>
#include <vector>

namespace qm {

/// The uniform bicubic B-spline through (m + 1) x (n + 1) points, row by row as in `vertexGrid`: rows first,
/// then columns, each with free ends. It has (m + 3) x (n + 3) control points and the knots -3 ... m + 3 and
/// -3 ... n + 3, so that point (i, j) lies at u = i, v = j. Time linear in the points.
/// \param size  m and n, both at least 1
[[nodiscard]] Patch interpolate(std::span<const Point> grid, std::array<int, 2> size);

/// The points of a segment's vertices, row by row.
[[nodiscard]] std::vector<Point> pointGrid(const QuadMesh& mesh, const Segment& segment);

/// A patch through the vertices of every segment.
/// \param jobs  threads
[[nodiscard]] std::vector<Patch> interpolateSegments(const QuadMesh& mesh, const Layout& layout,
                                                     unsigned jobs);

} // namespace qm

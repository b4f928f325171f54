/// \file A patch with few control points within a tolerance of its quads, between given border curves.
#pragma once

#include "bspline/patch_frame.h"
#include "bspline/surfaces.h"

#include <array>
#include <span>

namespace qm {

struct PatchFitInput {
    std::array<int, 2> size{};
    std::span<const Point> grid; ///< row by row as in `vertexGrid`
    /// The border curves, met exactly; the derivatives across them are only aimed at.
    std::array<std::array<SplineCurve, 2>, 2> border; ///< along u, along v
    /// Derivatives across the border at its vertices: S_v along u, S_u along v; empty where none is asked
    /// for.
    std::array<std::array<std::vector<Point>, 2>, 2> across;
    std::array<Point, 4> twists{}; ///< S_uv at (0, 0), (m, 0), (0, n), (m, n)
};

/// Least squares over a lattice of four samples for every edge, with more knots where an error is too large,
/// in the direction that causes it. Always succeeds if the border curves are within half the tolerance.
/// \param slides  errors are measured from the quads' tangent planes, not from the points of the same
/// parameters
[[nodiscard]] Patch fitPatch(const PatchFitInput& input, double tolerance, bool slides = false);

} // namespace qm

/// \file A patch with few control points within a tolerance of its quads, between given border curves.
#pragma once

#include "bspline/border_normals.h"
#include "bspline/closeness.h"
#include "bspline/surfaces.h"

#include <array>
#include <vector>

namespace qm {

struct PatchFitInput {
    std::array<int, 2> size{};
    std::vector<Point> grid;          ///< row by row as in `vertexGrid`
    std::vector<Closeness> closeness; ///< at the same vertices
    OnBorder<SplineCurve> border;     ///< met exactly
    /// Normals that the patch should have, zero where none is asked for. Only their parts across the curves
    /// count.
    OnBorder<std::vector<Point>> normals;
};

/// Least squares over a lattice of samples, with more knots where an error is too large, in the direction
/// that causes it; then without those that turn out not to be needed; then with the normals as close to the
/// prescribed ones as the tolerance allows. Errors are measured from the points of the same parameters, or,
/// where they slide, from the quads' tangent planes. Always succeeds if the border curves are within half the
/// tolerance.
[[nodiscard]] Patch fitPatch(const PatchFitInput& input, double tolerance);

} // namespace qm

/// \file A patch with few control points within a tolerance of its quads, between given border curves.
#pragma once

#include "bspline/closeness.h"
#include "bspline/patch_frame.h"
#include "bspline/surfaces.h"

#include <array>
#include <span>

namespace qm {

struct PatchFitInput {
    std::array<int, 2> size{};
    std::span<const Point> grid;          ///< row by row as in `vertexGrid`
    std::span<const Closeness> closeness; ///< at the same vertices
    /// The border curves, met exactly.
    std::array<std::array<SplineCurve, 2>, 2> border; ///< along u, along v
    /// Normals that the patch should have on its border, at `normalParameters` along u and v; zero where none
    /// is asked for. Only their parts across the curves count.
    std::array<std::array<std::vector<Point>, 2>, 2> normals;
};

/// Where a patch's normals on a border of so many edges are prescribed.
[[nodiscard]] std::vector<double> normalParameters(int edges);

/// Least squares over a lattice of samples, with more knots where an error is too large, in the direction
/// that causes it; then without those that turn out not to be needed; then with the normals as close to the
/// prescribed ones as the tolerance allows. Errors are measured from the points of the same parameters, or,
/// where they slide, from the quads' tangent planes. Always succeeds if the border curves are within half the
/// tolerance.
[[nodiscard]] Patch fitPatch(const PatchFitInput& input, double tolerance);

} // namespace qm

/// \file What a plane patch demands of its control points.
#pragma once

#include "bspline/fitting/planes/flat_patches.h"
#include "bspline/reference/planes/plane.h"
#include "bspline/splines/surfaces.h"

#include <cstddef>
#include <vector>

namespace qm {

/// By how much planes may be missed, relative to the largest distance of a point from the origin: those of
/// rounded points contradict one another a little.
constexpr double planePrecision = 1e-8;

/// A control point that must lie in a plane.
struct PlaneDemand {
    std::size_t unknown = 0;
    Plane plane;
};

/// All points in the patch's plane, and those of straight sides in theirs.
/// \param first  the unknown of the patch's first control point
[[nodiscard]] std::vector<PlaneDemand> demandsOf(const Patch& patch, const FlatPatch& flat,
                                                 std::size_t first);

/// Whether all points of a patch meet its demands.
/// \param distance  by which a plane may be missed
[[nodiscard]] bool isFlat(const Patch& patch, const FlatPatch& flat, double distance);

} // namespace qm

/// \file Replaces patches by planes, cylinders, cones, spheres and tori.
#pragma once

#include "bspline/splines/surfaces.h"

#include <Geom_ElementarySurface.hxx>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A surface without control points.
struct SimpleSurface {
    Handle(Geom_ElementarySurface) surface;
    bool reversed = false; ///< its normal is opposite to the patch's
    double tubeAngle = 0;  ///< of a torus: parameter v in the middle of the patch
};

/// The plane that contains all control points.
/// \param tolerance  largest distance of a control point from it
[[nodiscard]] std::optional<SimpleSurface> planeOf(const Patch& clampedPatch, double tolerance);

/// By patch: the first of plane, cylinder, cone, sphere and torus that is within the tolerance of the patch
/// and looks where it does (docs/METHOD.md#faces). Its poles, apex and seam are away from the patch. Radii
/// are at most ten times the patch's size, and curved surfaces nearer than a plane by far, because those of
/// flatter patches would be arbitrary. Neighbours share a surface, except for its seam, where one surface
/// suits both.
/// \param tolerances        by patch; 0 leaves it as it is
/// \param smoothNeighbours  pairs of patches
[[nodiscard]] std::vector<std::optional<SimpleSurface>>
simpleSurfacesOf(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                 const std::vector<std::array<std::size_t, 2>>& smoothNeighbours);

} // namespace qm

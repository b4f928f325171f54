/// \file Replaces patches by planes, cylinders, cones, spheres and tori.
#pragma once

#include "bspline/splines/surfaces.h"
#include "export/simple/smooth_borders.h"

#include <Geom_ElementarySurface.hxx>
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

/// By patch: the plane, cylinder, cone, sphere or torus that is within the tolerance of it and of as many of
/// its neighbours as possible (shape_regions.h, docs/METHOD.md#faces), unless a smooth border would become a
/// crease (smooth_borders.h). Its poles, apex and seam are away from the patch. Radii are at most ten times
/// the size of all patches on the surface, and curved surfaces nearer to these than a plane by far, because
/// those of flatter ones would be arbitrary. Patches of one surface share it, except for its seam.
/// \param tolerances  by patch; 0 leaves it as it is
/// \param planes      by patch: the plane that it is exactly, and stays
[[nodiscard]] std::vector<std::optional<SimpleSurface>>
simpleSurfacesOf(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                 std::vector<std::optional<SimpleSurface>> planes, const std::vector<SmoothBorder>& borders);

} // namespace qm

/// \file Planes, cylinders, cones, spheres and tori in the place of patches that are nothing else.
#pragma once

#include "bspline/splines/surfaces.h"

#include <Geom_ElementarySurface.hxx>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace qm {

/// A surface that needs no control points.
struct SimpleSurface {
    Handle(Geom_ElementarySurface) surface;
    bool reversed = false; ///< its normal points to the other side than the patch's
    double tubeAngle = 0;  ///< parameter v in the middle of the patch; of a torus
};

/// The plane in which all control points lie.
/// \param tolerance  how far they may be from it
[[nodiscard]] std::optional<SimpleSurface> planeOf(const Patch& clampedPatch, double tolerance);

/// For every patch the first of plane, cylinder, cone, sphere and torus that lies within the tolerance of it,
/// and whose normals are within three degrees of the patch's. Its poles, apex and seam keep away from the
/// patch. Radii are at most ten times the patch's size: the axes of flatter ones would be chance. Neighbours
/// have the same surface, but for its seam, where one is enough for both.
/// \param tolerances  of every patch; 0: it stays as it is
/// \param smoothNeighbours  pairs of patches
[[nodiscard]] std::vector<std::optional<SimpleSurface>>
simpleSurfacesOf(const std::vector<Patch>& clampedPatches, const std::vector<double>& tolerances,
                 const std::vector<std::array<std::size_t, 2>>& smoothNeighbours);

} // namespace qm

/// \file Patches and curves in OpenCASCADE's classes.
#pragma once

#include "bspline/splines/spline_curve.h"
#include "bspline/splines/surfaces.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <array>
#include <gp_Pnt.hxx>

namespace qm {

[[nodiscard]] gp_Pnt toGp(const Point& point);
[[nodiscard]] Point fromGp(const gp_Pnt& point);

/// \param clampedPatch  of degrees 1 to 3
/// \throw Standard_Failure  if OpenCASCADE considers two knots equal
[[nodiscard]] Handle(Geom_BSplineSurface) splineSurface(const Patch& clampedPatch);
[[nodiscard]] Handle(Geom_BSplineCurve) splineCurve(const SplineCurve& curve);
/// The curve plus a linear function of its parameter, so that it begins and ends at given points.
[[nodiscard]] Handle(Geom_BSplineCurve)
    withEnds(const Handle(Geom_BSplineCurve) & clamped, const std::array<gp_Pnt, 2>& ends);
/// A straight line from one point to another, over the parameters from first to last.
[[nodiscard]] Handle(Geom2d_BSplineCurve)
    line(const gp_Pnt2d& from, const gp_Pnt2d& to, double first, double last);

/// Removes repetitions of inner knots that the patch's shape does not need.
/// \param tolerance  largest distance by which a point of the surface may move
[[nodiscard]] Patch withoutNeedlessKnots(const Patch& clampedPatch, double tolerance);
/// The same for a single inner knot along u, which the patch must have.
[[nodiscard]] Patch withoutNeedlessKnot(const Patch& clampedPatch, double knot, double tolerance);

} // namespace qm

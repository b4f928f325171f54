/// \file Patches and curves as OpenCASCADE's.
#pragma once

#include "bspline/splines/spline_curve.h"
#include "bspline/splines/surfaces.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <gp_Pnt.hxx>

namespace qm {

[[nodiscard]] gp_Pnt place(const Point& point);
[[nodiscard]] Point fromPlace(const gp_Pnt& place);

/// \param clampedPatch  of degrees 1 to 3
/// \throw Standard_Failure  if OpenCASCADE takes knots for equal
[[nodiscard]] Handle(Geom_BSplineSurface) splineSurface(const Patch& clampedPatch);
[[nodiscard]] Handle(Geom_BSplineCurve) splineCurve(const SplineCurve& curve);
/// A straight line from one point to another, over [0, length].
[[nodiscard]] Handle(Geom2d_BSplineCurve) line(const gp_Pnt2d& from, const gp_Pnt2d& to, double length);

/// The patch without inner knots that are there more often than its shape needs.
/// \param tolerance  how far a point of the surface may move
[[nodiscard]] Patch withoutNeedlessKnots(const Patch& clampedPatch, double tolerance);

} // namespace qm

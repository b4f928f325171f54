/// \file Points, curves and surfaces in a STEP file.
#pragma once

#include "export/files/step_file.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

namespace qm {

[[nodiscard]] StepId addPoint(StepFile& file, const gp_Pnt& point);
[[nodiscard]] StepId addPlacement(StepFile& file, const gp_Ax3& axes);
/// \param curve  a spline that is not rational, a line, a circle or an ellipse
[[nodiscard]] StepId addCurve(StepFile& file, const Handle(Geom_Curve) & curve);
/// A curve in the parameter plane of a surface, by STEP's parameters: along a cone they are measured on its
/// axis (ISO 10303-42), while OpenCASCADE's are measured on the cone itself.
[[nodiscard]] StepId addPlaneCurve(StepFile& file, const Handle(Geom2d_BSplineCurve) & curve,
                                   const Handle(Geom_Surface) & surface);
/// \param surface  not rational; or a plane, cylinder, cone, sphere or torus with right-handed axes
[[nodiscard]] StepId addSurface(StepFile& file, const Handle(Geom_Surface) & surface);

} // namespace qm

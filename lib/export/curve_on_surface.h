/// \file Curves in the parameter planes of planes, cylinders, cones, spheres and tori.
#pragma once

#include "export/simple_surface.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>

namespace qm {

struct CurveOnSurface {
    Handle(Geom2d_BSplineCurve)
        curve;      ///< over the parameters of the curve in space; none in a plane, which needs none
    double gap = 0; ///< the largest distance between points of the same parameter
};

/// Of the points of the surface next to those of the curve.
[[nodiscard]] CurveOnSurface curveOnSurface(const Handle(Geom_BSplineCurve) & curve, const SimpleSurface& on);

} // namespace qm

/// \file Curves in the parameter planes of planes, cylinders, cones, spheres and tori.
#pragma once

#include "export/simple_surface.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <array>
#include <vector>

namespace qm {

struct CurveOnSurface {
    Handle(Geom2d_BSplineCurve)
        curve;      ///< over the parameters of the curve in space; none in a plane, which needs none
    double gap = 0; ///< the largest distance between points of the same parameter
};

/// The point next to another that lies on all of some surfaces, or comes nearest to that.
[[nodiscard]] gp_Pnt commonPoint(const gp_Pnt& near, const std::vector<SimpleSurface>& surfaces);

/// Where two surfaces meet next to a curve, over the same parameters: it is on both to the resolution,
/// wherever they do meet.
/// \param ends  of the result; on both surfaces
[[nodiscard]] Handle(Geom_BSplineCurve)
    commonCurve(const Handle(Geom_BSplineCurve) & near, const std::array<gp_Pnt, 2>& ends,
                const std::vector<SimpleSurface>& both, double resolution);

/// Of the points of the surface next to those of the curve.
[[nodiscard]] CurveOnSurface curveOnSurface(const Handle(Geom_BSplineCurve) & curve, const SimpleSurface& on);

} // namespace qm

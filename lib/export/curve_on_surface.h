/// \file Curves in the parameter planes of planes, cylinders, cones, spheres and tori.
#pragma once

#include "export/simple_surface.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <array>
#include <vector>

namespace qm {

struct CurveOnSurface {
    /// Over the parameters of the curve in space; none in a plane, which needs none.
    Handle(Geom2d_BSplineCurve) curve;
    double gap = 0; ///< the largest distance between points of the same parameter
};

/// A point near another one that lies on all of the surfaces, or comes nearest to that.
[[nodiscard]] gp_Pnt commonPoint(const gp_Pnt& near, const std::vector<SimpleSurface>& surfaces);

/// The curve along which two surfaces meet near a given curve, over the same parameters: within the
/// resolution of both, wherever they do meet.
/// \param ends  of the result; on both surfaces
[[nodiscard]] Handle(Geom_BSplineCurve)
    commonCurve(const Handle(Geom_BSplineCurve) & near, const std::array<gp_Pnt, 2>& ends,
                const std::vector<SimpleSurface>& both, double resolution);

/// The curve through the points of the surface that are nearest to those of a curve in space.
[[nodiscard]] CurveOnSurface curveOnSurface(const Handle(Geom_BSplineCurve) & curve, const SimpleSurface& on);

} // namespace qm

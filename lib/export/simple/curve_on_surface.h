/// \file Curves in the parameter planes of planes, cylinders, cones, spheres and tori.
#pragma once

#include "export/geometry/curve_piece.h"
#include "export/simple/simple_surface.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <array>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <variant>
#include <vector>

namespace qm {

struct CurveOnSurface {
    /// Over the parameters of the curve in space; none in a plane, which does not need one.
    Handle(Geom2d_BSplineCurve) curve;
    double gap = 0; ///< largest distance between points of the same parameter
};

/// The numbers by which a surface is defined.
using ElementaryNumbers = std::variant<gp_Pln, gp_Cylinder, gp_Cone, gp_Sphere, gp_Torus>;

[[nodiscard]] ElementaryNumbers numbersOf(const Handle(Geom_ElementarySurface) & surface);

/// Parameters u and v of the point of a surface that is nearest to a point.
[[nodiscard]] gp_Pnt2d parametersAt(const Handle(Geom_ElementarySurface) & surface, const gp_Pnt& point);

/// The same angle, within half a turn of another.
[[nodiscard]] double angleNear(double angle, double other);

/// A point near a given one that lies on all of the surfaces, or is nearest to that.
[[nodiscard]] gp_Pnt commonPoint(const gp_Pnt& near, const std::vector<SimpleSurface>& surfaces);

/// The curve in which two surfaces meet near a given curve, over the same parameters: within the resolution
/// of both surfaces wherever they meet.
/// \param ends  of the result; they lie on both surfaces
[[nodiscard]] Handle(Geom_BSplineCurve)
    commonCurve(const Handle(Geom_BSplineCurve) & near, const std::array<gp_Pnt, 2>& ends,
                const std::vector<SimpleSurface>& both, double resolution);

/// The curve through the points of the surface that are nearest to the points of a curve in space; straight
/// if it is so within the resolution.
[[nodiscard]] CurveOnSurface curveOnSurface(const CurvePiece& piece, const SimpleSurface& on,
                                            double resolution);

} // namespace qm

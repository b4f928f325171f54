#include "export/curve_on_surface.h"

#include <ElSLib.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace qm {
namespace {

constexpr int steps = 4;  ///< interpolated points in every knot interval
constexpr int checks = 3; ///< samples of the gap between two of those

gp_Pnt2d nearest(const Handle(Geom_ElementarySurface) & surface, const gp_Pnt& point) {
    double u = 0;
    double v = 0;
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
        ElSLib::Parameters(plane->Pln(), point, u, v);
    else if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        ElSLib::Parameters(cylinder->Cylinder(), point, u, v);
    else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull())
        ElSLib::Parameters(cone->Cone(), point, u, v);
    else if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        ElSLib::Parameters(sphere->Sphere(), point, u, v);
    else
        ElSLib::Parameters(Handle(Geom_ToroidalSurface)::DownCast(surface)->Torus(), point, u, v);
    return {u, v};
}

/// The same angle, within half a turn of another.
double angleNear(double angle, double other) {
    constexpr double turn = 2 * std::numbers::pi;
    return angle - turn * std::round((angle - other) / turn);
}

std::vector<double> parametersOf(const Geom_BSplineCurve& curve, int perInterval) {
    std::vector<double> result{curve.FirstParameter()};
    for (int k = curve.FirstUKnotIndex(); k < curve.LastUKnotIndex(); ++k)
        for (int step = 1; step <= perInterval; ++step)
            result.push_back(curve.Knot(k) + (curve.Knot(k + 1) - curve.Knot(k)) * step / perInterval);
    return result;
}

} // namespace

CurveOnSurface curveOnSurface(const Handle(Geom_BSplineCurve) & curve, const SimpleSurface& on) {
    const Handle(Geom_ElementarySurface)& surface = on.surface;
    CurveOnSurface result;
    const bool isPlane = surface->IsKind(STANDARD_TYPE(Geom_Plane));
    if (!isPlane) {
        const auto parameters = parametersOf(*curve, steps);
        const auto size = static_cast<int>(parameters.size());
        const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, size);
        const Handle(TColStd_HArray1OfReal) at = new TColStd_HArray1OfReal(1, size);
        // The patch lies about the middle of all angles u, opposite to the seam.
        gp_Pnt2d last(std::numbers::pi, on.tubeAngle);
        for (int k = 1; k <= size; ++k) {
            const double t = parameters[static_cast<std::size_t>(k - 1)];
            gp_Pnt2d point = nearest(surface, curve->Value(t));
            if (surface->IsUPeriodic()) point.SetX(angleNear(point.X(), last.X()));
            if (surface->IsVPeriodic()) point.SetY(angleNear(point.Y(), last.Y()));
            points->SetValue(k, last = point);
            at->SetValue(k, t);
        }
        Geom2dAPI_Interpolate interpolation(points, at, Standard_False, 1e-12);
        interpolation.Perform();
        result.curve = interpolation.Curve();
    }
    for (const double t : parametersOf(*curve, steps * checks)) {
        const gp_Pnt point = curve->Value(t);
        const gp_Pnt2d at = isPlane ? nearest(surface, point) : result.curve->Value(t);
        result.gap = std::max(result.gap, point.Distance(surface->Value(at.X(), at.Y())));
    }
    return result;
}

} // namespace qm

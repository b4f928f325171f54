#include "export/files/step_geometry.h"

#include "base/at.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <array>
#include <cmath>
#include <vector>

namespace qm {
namespace {

StepId addDirection(StepFile& file, const gp_Dir& direction) {
    return file.add("DIRECTION", "", std::array{direction.X(), direction.Y(), direction.Z()});
}

StepId addPoint(StepFile& file, const gp_Pnt2d& point) {
    return file.add("CARTESIAN_POINT", "", std::array{point.X(), point.Y()});
}

/// \param curve  in space or in a plane
template <class Curve> StepId addSplineCurve(StepFile& file, const Curve& curve) {
    std::vector<StepId> poles;
    for (int k = 1; k <= curve.NbPoles(); ++k)
        poles.push_back(addPoint(file, curve.Pole(k)));
    return file.add("B_SPLINE_CURVE_WITH_KNOTS", "", curve.Degree(), poles, unspecified, false, false,
                    curve.Multiplicities(), curve.Knots(), unspecified);
}

StepId addSplineSurface(StepFile& file, const Geom_BSplineSurface& surface) {
    std::vector<std::vector<StepId>> poles(at(surface.NbUPoles()));
    for (int i = 1; i <= surface.NbUPoles(); ++i)
        for (int j = 1; j <= surface.NbVPoles(); ++j)
            poles[at(i - 1)].push_back(addPoint(file, surface.Pole(i, j)));
    return file.add("B_SPLINE_SURFACE_WITH_KNOTS", "", surface.UDegree(), surface.VDegree(), poles,
                    unspecified, false, false, false, surface.UMultiplicities(), surface.VMultiplicities(),
                    surface.UKnots(), surface.VKnots(), unspecified);
}

} // namespace

StepId addPoint(StepFile& file, const gp_Pnt& point) {
    return file.add("CARTESIAN_POINT", "", std::array{point.X(), point.Y(), point.Z()});
}

StepId addPlacement(StepFile& file, const gp_Ax3& axes) {
    const StepId location = addPoint(file, axes.Location());
    const StepId axis = addDirection(file, axes.Direction());
    return file.add("AXIS2_PLACEMENT_3D", "", location, axis, addDirection(file, axes.XDirection()));
}

StepId addCurve(StepFile& file, const Handle(Geom_Curve) & curve) {
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve); !spline.IsNull())
        return addSplineCurve(file, *spline);
    if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull()) {
        const StepId point = addPoint(file, line->Position().Location());
        const StepId direction = addDirection(file, line->Position().Direction());
        return file.add("LINE", "", point, file.add("VECTOR", "", direction, 1.0));
    }
    const auto conic = Handle(Geom_Conic)::DownCast(curve);
    const StepId placement = addPlacement(file, gp_Ax3(conic->Position()));
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
        return file.add("CIRCLE", "", placement, circle->Radius());
    const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve);
    return file.add("ELLIPSE", "", placement, ellipse->MajorRadius(), ellipse->MinorRadius());
}

StepId addPlaneCurve(StepFile& file, const Handle(Geom2d_BSplineCurve) & curve,
                     const Handle(Geom_Surface) & surface) {
    const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface);
    if (cone.IsNull()) return addSplineCurve(file, *curve);
    const auto onAxis = Handle(Geom2d_BSplineCurve)::DownCast(curve->Copy());
    for (int k = 1; k <= onAxis->NbPoles(); ++k) {
        const gp_Pnt2d& pole = onAxis->Pole(k);
        onAxis->SetPole(k, {pole.X(), pole.Y() * std::cos(cone->SemiAngle())});
    }
    return addSplineCurve(file, *onAxis);
}

StepId addSurface(StepFile& file, const Handle(Geom_Surface) & surface) {
    const auto simple = [&](const char* name, const gp_Ax3& axes, auto... numbers) {
        return file.add(name, "", addPlacement(file, axes), numbers...);
    };
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
        return addSplineSurface(file, *spline);
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
        return simple("PLANE", plane->Position());
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        return simple("CYLINDRICAL_SURFACE", cylinder->Position(), cylinder->Radius());
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull())
        return simple("CONICAL_SURFACE", cone->Position(), cone->RefRadius(), cone->SemiAngle());
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        return simple("SPHERICAL_SURFACE", sphere->Position(), sphere->Radius());
    const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
    return simple("TOROIDAL_SURFACE", torus->Position(), torus->MajorRadius(), torus->MinorRadius());
}

} // namespace qm

#include "export/step_geometry.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <vector>

namespace qm {
namespace {

template <class Array> auto listed(const Array& array) {
    std::vector<typename Array::value_type> values;
    for (int k = array.Lower(); k <= array.Upper(); ++k)
        values.push_back(array(k));
    return values;
}

StepId addDirection(StepFile& file, const gp_Dir& direction) {
    return file.add(StepText("DIRECTION('',").reals({direction.X(), direction.Y(), direction.Z()}).raw(")"));
}

/// Multiplicities, knots, and the end of the entity.
template <class Curve> StepText& appendKnots(StepText& text, const Curve& curve) {
    return text.raw(",.UNSPECIFIED.,.F.,.F.,")
        .integers(listed(curve.Multiplicities()))
        .raw(",")
        .reals(listed(curve.Knots()))
        .raw(",.UNSPECIFIED.)");
}

StepId addSplineSurface(StepFile& file, const Geom_BSplineSurface& surface) {
    StepText text("B_SPLINE_SURFACE_WITH_KNOTS('',");
    text.integer(surface.UDegree()).raw(",").integer(surface.VDegree());
    for (int i = 1; i <= surface.NbUPoles(); ++i) {
        std::vector<StepId> row;
        for (int j = 1; j <= surface.NbVPoles(); ++j)
            row.push_back(addPoint(file, surface.Pole(i, j)));
        text.raw(i == 1 ? ",(" : ",").ids(row);
    }
    text.raw("),.UNSPECIFIED.,.F.,.F.,.F.,")
        .integers(listed(surface.UMultiplicities()))
        .raw(",")
        .integers(listed(surface.VMultiplicities()))
        .raw(",")
        .reals(listed(surface.UKnots()))
        .raw(",")
        .reals(listed(surface.VKnots()));
    return file.add(text.raw(",.UNSPECIFIED.)"));
}

} // namespace

StepId addPoint(StepFile& file, const gp_Pnt& point) {
    return file.add(StepText("CARTESIAN_POINT('',").reals({point.X(), point.Y(), point.Z()}).raw(")"));
}

StepId addPlacement(StepFile& file, const gp_Ax3& axes) {
    const StepId location = addPoint(file, axes.Location());
    const StepId axis = addDirection(file, axes.Direction());
    const StepId reference = addDirection(file, axes.XDirection());
    return file.add(
        StepText("AXIS2_PLACEMENT_3D('',").id(location).raw(",").id(axis).raw(",").id(reference).raw(")"));
}

StepId addCurve(StepFile& file, const Handle(Geom_BSplineCurve) & curve) {
    std::vector<StepId> poles;
    for (int k = 1; k <= curve->NbPoles(); ++k)
        poles.push_back(addPoint(file, curve->Pole(k)));
    StepText text("B_SPLINE_CURVE_WITH_KNOTS('',");
    text.integer(curve->Degree()).raw(",").ids(poles);
    return file.add(appendKnots(text, *curve));
}

StepId addPlaneCurve(StepFile& file, const Handle(Geom2d_BSplineCurve) & curve) {
    std::vector<StepId> poles;
    for (int k = 1; k <= curve->NbPoles(); ++k)
        poles.push_back(file.add(
            StepText("CARTESIAN_POINT('',").reals({curve->Pole(k).X(), curve->Pole(k).Y()}).raw(")")));
    StepText text("B_SPLINE_CURVE_WITH_KNOTS('',");
    text.integer(curve->Degree()).raw(",").ids(poles);
    return file.add(appendKnots(text, *curve));
}

StepId addSurface(StepFile& file, const Handle(Geom_Surface) & surface) {
    const auto simple = [&](const char* name, const gp_Ax3& axes, std::initializer_list<double> numbers) {
        const StepId placement = addPlacement(file, axes);
        StepText text(name);
        text.raw("('',").id(placement);
        for (const double number : numbers)
            text.raw(",").real(number);
        return file.add(text.raw(")"));
    };
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface); !spline.IsNull())
        return addSplineSurface(file, *spline);
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull())
        return simple("PLANE", plane->Position(), {});
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        return simple("CYLINDRICAL_SURFACE", cylinder->Position(), {cylinder->Radius()});
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull())
        return simple("CONICAL_SURFACE", cone->Position(), {cone->RefRadius(), cone->SemiAngle()});
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        return simple("SPHERICAL_SURFACE", sphere->Position(), {sphere->Radius()});
    const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
    return simple("TOROIDAL_SURFACE", torus->Position(), {torus->MajorRadius(), torus->MinorRadius()});
}

} // namespace qm

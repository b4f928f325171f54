#include "export/geometry/geometry.h"

#include "base/at.h"

#include <BSplCLib.hxx>
#include <vector>

namespace qm {
namespace {

/// Distinct knots and how often each is there, as OpenCASCADE wants them.
struct KnotTable {
    TColStd_Array1OfReal values;
    TColStd_Array1OfInteger multiplicities;
};

KnotTable knotTable(const std::vector<double>& knots) {
    const TColStd_Array1OfReal sequence(knots.front(), 1, static_cast<int>(knots.size()));
    const int size = BSplCLib::KnotsLength(sequence);
    KnotTable table{TColStd_Array1OfReal(1, size), TColStd_Array1OfInteger(1, size)};
    BSplCLib::Knots(sequence, table.values, table.multiplicities);
    return table;
}

/// Of an inner knot along u, as far as the surface does not need them.
/// \return whether there were any
bool removeRepetitions(Geom_BSplineSurface& surface, int knot, double tolerance) {
    bool removed = false;
    while (surface.UMultiplicity(knot) > 1 &&
           surface.RemoveUKnot(knot, surface.UMultiplicity(knot) - 1, tolerance))
        removed = true;
    return removed;
}

/// A patch with the knots and control points of a surface.
Patch withKnotsOf(const Geom_BSplineSurface& surface, Patch patch) {
    const TColStd_Array1OfReal& u = surface.UKnotSequence();
    const TColStd_Array1OfReal& v = surface.VKnotSequence();
    patch.knots = {std::vector(u.begin(), u.end()), std::vector(v.begin(), v.end())};
    patch.count = {surface.NbUPoles(), surface.NbVPoles()};
    patch.controlPoints.clear();
    for (int j = 1; j <= patch.count[1]; ++j)
        for (int i = 1; i <= patch.count[0]; ++i)
            patch.controlPoints.push_back(fromGp(surface.Pole(i, j)));
    return patch;
}

} // namespace

gp_Pnt toGp(const Point& point) {
    return {point[0], point[1], point[2]};
}

Point fromGp(const gp_Pnt& point) {
    return {point.X(), point.Y(), point.Z()};
}

Handle(Geom_BSplineSurface) splineSurface(const Patch& clampedPatch) {
    TColgp_Array2OfPnt poles(1, clampedPatch.count[0], 1, clampedPatch.count[1]);
    auto point = clampedPatch.controlPoints.begin();
    for (int j = 1; j <= clampedPatch.count[1]; ++j)
        for (int i = 1; i <= clampedPatch.count[0]; ++i)
            poles.SetValue(i, j, toGp(*point++));
    const KnotTable u = knotTable(clampedPatch.knots[0]);
    const KnotTable v = knotTable(clampedPatch.knots[1]);
    return new Geom_BSplineSurface(poles, u.values, v.values, u.multiplicities, v.multiplicities,
                                   clampedPatch.degree[0], clampedPatch.degree[1]);
}

Handle(Geom_BSplineCurve) splineCurve(const SplineCurve& curve) {
    TColgp_Array1OfPnt poles(1, static_cast<int>(curve.points.size()));
    for (int k = 0; k < poles.Length(); ++k)
        poles.SetValue(k + 1, toGp(curve.points[at(k)]));
    const KnotTable knots = knotTable(curve.knots);
    return new Geom_BSplineCurve(poles, knots.values, knots.multiplicities, 3);
}

Handle(Geom_BSplineCurve)
    withEnds(const Handle(Geom_BSplineCurve) & clamped, const std::array<gp_Pnt, 2>& ends) {
    auto curve = Handle(Geom_BSplineCurve)::DownCast(clamped->Copy());
    const gp_XYZ moveFirst = ends[0].XYZ() - clamped->StartPoint().XYZ();
    const gp_XYZ moveLast = ends[1].XYZ() - clamped->EndPoint().XYZ();
    const TColStd_Array1OfReal& knots = clamped->KnotSequence();
    const double first = clamped->FirstParameter();
    const double last = clamped->LastParameter();
    for (int k = 1; k <= curve->NbPoles(); ++k) {
        double parameter = 0; // of a spline that is linear, where it has this control point
        for (int i = 1; i <= curve->Degree(); ++i)
            parameter += knots(k + i) / curve->Degree();
        const double share = (parameter - first) / (last - first);
        curve->SetPole(k, curve->Pole(k).XYZ() + moveFirst * (1 - share) + moveLast * share);
    }
    return curve;
}

Handle(Geom2d_BSplineCurve) line(const gp_Pnt2d& from, const gp_Pnt2d& to, double first, double last) {
    TColgp_Array1OfPnt2d poles(1, 2);
    poles.SetValue(1, from);
    poles.SetValue(2, to);
    const KnotTable knots = knotTable({first, first, last, last});
    return new Geom2d_BSplineCurve(poles, knots.values, knots.multiplicities, 1);
}

Patch withoutNeedlessKnots(const Patch& clampedPatch, double tolerance) {
    const Handle(Geom_BSplineSurface) surface = splineSurface(clampedPatch);
    bool removed = false;
    for (int k = surface->NbUKnots() - 1; k > 1; --k)
        removed = removeRepetitions(*surface, k, tolerance) || removed;
    for (int k = surface->NbVKnots() - 1; k > 1; --k)
        while (surface->VMultiplicity(k) > 1 &&
               surface->RemoveVKnot(k, surface->VMultiplicity(k) - 1, tolerance))
            removed = true;
    return removed ? withKnotsOf(*surface, clampedPatch) : clampedPatch;
}

Patch withoutNeedlessKnot(const Patch& clampedPatch, double knot, double tolerance) {
    const Handle(Geom_BSplineSurface) surface = splineSurface(clampedPatch);
    int number = 2;
    while (surface->UKnot(number) < knot)
        ++number;
    return removeRepetitions(*surface, number, tolerance) ? withKnotsOf(*surface, clampedPatch)
                                                          : clampedPatch;
}

} // namespace qm

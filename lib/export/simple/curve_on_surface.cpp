#include "export/simple/curve_on_surface.h"

#include "base/at.h"
#include "export/geometry/geometry.h"

#include <ElSLib.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace qm {
namespace {

constexpr int steps = 4; ///< interpolated points in every knot interval, at first
constexpr int maxSteps = 64;
/// Twice the steps make a gap 16 times smaller, except where surfaces do not meet. What remains of the gap
/// becomes the edge's tolerance.
constexpr double worthwhile = 0.5;
constexpr int checks = 3; ///< samples of the gap between two of those

gp_Pnt projected(const gp_Pnt& point, const SimpleSurface& on) {
    const gp_Pnt2d at = parametersAt(on.surface, point);
    return on.surface->Value(at.X(), at.Y());
}

/// Points closer than this are one, to OpenCASCADE's interpolation: so small that none is left out.
constexpr double samePoint = 1e-12;

/// A curve through points at parameters; C2.
template <class Interpolation, class Array, class Point>
auto interpolated(const std::vector<Point>& points, const std::vector<double>& parameters) {
    const auto size = static_cast<int>(points.size());
    const opencascade::handle<Array> through = new Array(1, size);
    const Handle(TColStd_HArray1OfReal) places = new TColStd_HArray1OfReal(1, size);
    for (int k = 1; k <= size; ++k) {
        through->SetValue(k, points[at(k - 1)]);
        places->SetValue(k, parameters[at(k - 1)]);
    }
    Interpolation interpolation(through, places, Standard_False, samePoint);
    interpolation.Perform();
    return interpolation.Curve();
}

/// The parameters of the nearest points of a surface, as they continue one another.
std::vector<gp_Pnt2d> pointsOn(const SimpleSurface& on, const CurvePiece& piece,
                               const std::vector<double>& parameters) {
    std::vector<gp_Pnt2d> points;
    // The patch lies about the middle of all angles u, opposite to the seam.
    gp_Pnt2d last(std::numbers::pi, on.tubeAngle);
    for (const double t : parameters) {
        gp_Pnt2d point = parametersAt(on.surface, piece.at(t));
        if (on.surface->IsUPeriodic()) point.SetX(angleNear(point.X(), last.X()));
        if (on.surface->IsVPeriodic()) point.SetY(angleNear(point.Y(), last.Y()));
        points.push_back(last = point);
    }
    return points;
}

/// A curve through more and more points, until it is within half the resolution or they no longer help.
/// \param make  the curve through a number of points in every interval, with its gap
template <class Make> auto refined(double resolution, const Make& make) {
    auto best = make(steps);
    for (int perInterval = 2 * steps; best.gap > resolution / 2 && perInterval <= maxSteps;
         perInterval *= 2) {
        auto finer = make(perInterval);
        if (!(finer.gap < worthwhile * best.gap)) break;
        best = std::move(finer);
    }
    return best;
}

} // namespace

ElementaryNumbers numbersOf(const Handle(Geom_ElementarySurface) & surface) {
    if (const auto plane = Handle(Geom_Plane)::DownCast(surface); !plane.IsNull()) return plane->Pln();
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull())
        return cylinder->Cylinder();
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) return cone->Cone();
    if (const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull())
        return sphere->Sphere();
    return Handle(Geom_ToroidalSurface)::DownCast(surface)->Torus();
}

gp_Pnt2d parametersAt(const Handle(Geom_ElementarySurface) & surface, const gp_Pnt& point) {
    double u = 0;
    double v = 0;
    std::visit([&](const auto& numbers) { ElSLib::Parameters(numbers, point, u, v); }, numbersOf(surface));
    return {u, v};
}

double angleNear(double angle, double other) {
    constexpr double turn = 2 * std::numbers::pi;
    return angle - turn * std::round((angle - other) / turn);
}

gp_Pnt commonPoint(const gp_Pnt& near, const std::vector<SimpleSurface>& surfaces) {
    constexpr int rounds = 100; // each halves the distance at least where they meet at 45 degrees or more
    constexpr double rounding = 1e-15;
    gp_XYZ point = near.XYZ();
    for (int round = 0; round < rounds; ++round) {
        const gp_XYZ before = point;
        for (const SimpleSurface& surface : surfaces)
            point = projected(point, surface).XYZ();
        if ((point - before).Modulus() <= rounding * before.Modulus()) break;
    }
    return point;
}

Handle(Geom_BSplineCurve)
    commonCurve(const Handle(Geom_BSplineCurve) & near, const std::array<gp_Pnt, 2>& ends,
                const std::vector<SimpleSurface>& both, double resolution) {
    const double first = near->FirstParameter();
    const double last = near->LastParameter();
    const gp_XYZ moveFirst = ends[0].XYZ() - near->Value(first).XYZ();
    const gp_XYZ moveLast = ends[1].XYZ() - near->Value(last).XYZ();
    const auto pointAt = [&](double t) {
        const double share = (t - first) / (last - first);
        return commonPoint(near->Value(t).XYZ() + moveFirst * (1 - share) + moveLast * share, both);
    };
    struct Common {
        Handle(Geom_BSplineCurve) curve;
        double gap = 0;
    };
    const auto make = [&](int perInterval) {
        const auto parameters = parametersOf(wholeCurve(near), perInterval);
        std::vector<gp_Pnt> points{ends[0]};
        for (std::size_t k = 1; k + 1 < parameters.size(); ++k)
            points.push_back(pointAt(parameters[k]));
        points.push_back(ends[1]);
        Common found{interpolated<GeomAPI_Interpolate, TColgp_HArray1OfPnt>(points, parameters)};
        for (std::size_t k = 0; k + 1 < parameters.size(); ++k) {
            const gp_Pnt between = found.curve->Value((parameters[k] + parameters[k + 1]) / 2);
            for (const SimpleSurface& surface : both)
                found.gap = std::max(found.gap, between.Distance(projected(between, surface)));
        }
        return found;
    };
    return refined(resolution, make).curve;
}

CurveOnSurface curveOnSurface(const CurvePiece& piece, const SimpleSurface& on, double resolution) {
    const Handle(Geom_ElementarySurface)& surface = on.surface;
    const auto gapOf = [&](int perInterval, const auto& pointOnSurface) {
        double gap = 0;
        for (const double t : parametersOf(piece, perInterval * checks)) {
            const gp_Pnt2d at = pointOnSurface(t);
            gap = std::max(gap, piece.at(t).Distance(surface->Value(at.X(), at.Y())));
        }
        return gap;
    };
    if (surface->IsKind(STANDARD_TYPE(Geom_Plane)))
        return {{}, gapOf(steps, [&](double t) { return parametersAt(surface, piece.at(t)); })};
    const auto along = [&](int perInterval, const Handle(Geom2d_BSplineCurve) & curve) -> CurveOnSurface {
        return {curve, gapOf(perInterval, [&](double t) { return curve->Value(t); })};
    };
    const auto few = pointsOn(on, piece, parametersOf(piece, steps));
    CurveOnSurface straight = along(steps, line(few.front(), few.back(), piece.first, piece.last));
    if (straight.gap <= resolution / 2) return straight;
    return refined(resolution, [&](int perInterval) {
        const auto parameters = parametersOf(piece, perInterval);
        return along(perInterval, interpolated<Geom2dAPI_Interpolate, TColgp_HArray1OfPnt2d>(
                                      pointsOn(on, piece, parameters), parameters));
    });
}

} // namespace qm

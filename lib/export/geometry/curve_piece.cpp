#include "export/geometry/curve_piece.h"

#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

/// Where the intervals of a piece end, its own ends included.
std::vector<double> breaksOf(const CurvePiece& piece) {
    std::vector<double> breaks;
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(piece.curve); !spline.IsNull()) {
        for (int k = spline->FirstUKnotIndex(); k <= spline->LastUKnotIndex(); ++k)
            breaks.push_back(spline->Knot(k));
        return breaks;
    }
    constexpr double eighth = std::numbers::pi / 4;
    const int intervals = piece.curve->IsKind(STANDARD_TYPE(Geom_Line))
                              ? 1
                              : std::max(1, static_cast<int>(std::ceil((piece.last - piece.first) / eighth)));
    for (int k = 0; k <= intervals; ++k)
        breaks.push_back(std::lerp(piece.first, piece.last, static_cast<double>(k) / intervals));
    return breaks;
}

} // namespace

CurvePiece wholeCurve(const Handle(Geom_Curve) & spline) {
    return {spline, spline->FirstParameter(), spline->LastParameter()};
}

std::vector<gp_Pnt> controlPoints(const CurvePiece& piece) {
    auto spline = Handle(Geom_BSplineCurve)::DownCast(piece.curve);
    if (spline.IsNull())
        spline =
            GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(piece.curve, piece.first, piece.last));
    const TColgp_Array1OfPnt& poles = spline->Poles();
    return {poles.begin(), poles.end()};
}

std::vector<double> parametersOf(const CurvePiece& piece, int perInterval) {
    return steppedKnots(breaksOf(piece), perInterval);
}

std::vector<double> steppedKnots(const std::vector<double>& knots, int perInterval) {
    std::vector<double> result{knots.front()};
    for (std::size_t k = 1; k < knots.size(); ++k)
        for (int step = 1; step <= perInterval && knots[k - 1] < knots[k]; ++step)
            result.push_back(knots[k - 1] + (knots[k] - knots[k - 1]) * step / perInterval);
    return result;
}

} // namespace qm

#include "export/simple/conic_curve.h"

#include "base/infinity.h"
#include "export/simple/curve_on_surface.h"
#include "export/simple/straight_seam.h"

#include <ElCLib.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <IntAna_QuadQuadGeo.hxx>
#include <Precision.hxx>
#include <cmath>
#include <concepts>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace qm {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// OpenCASCADE knows every pair in one order only, and not all with the same tolerances.
struct Intersection {
    double resolution;

    template <class One, class Other>
    IntAna_QuadQuadGeo operator()(const One& one, const Other& other) const {
        using Result = IntAna_QuadQuadGeo;
        if constexpr (std::constructible_from<Result, One, Other, double, double>)
            return {one, other, Precision::Angular(), resolution};
        else if constexpr (std::constructible_from<Result, One, Other, double>)
            return {one, other, resolution};
        else if constexpr (std::constructible_from<Result, One, Other>)
            return {one, other};
        else
            return (*this)(other, one);
    }
};

/// The curves in which two surfaces meet, as far as they are lines, circles or ellipses.
std::vector<Handle(Geom_Curve)> meetings(const std::array<SimpleSurface, 2>& surfaces, double resolution) {
    const IntAna_QuadQuadGeo found =
        std::visit(Intersection{resolution}, numbersOf(surfaces[0].surface), numbersOf(surfaces[1].surface));
    std::vector<Handle(Geom_Curve)> curves;
    if (!found.IsDone()) return curves;
    for (int k = 1; k <= found.NbSolutions(); ++k)
        switch (found.TypeInter()) {
        case IntAna_Line:
            curves.emplace_back(new Geom_Line(found.Line(k)));
            break;
        case IntAna_Circle:
            curves.emplace_back(new Geom_Circle(found.Circle(k)));
            break;
        case IntAna_Ellipse: {
            const gp_Elips ellipse = found.Ellipse(k);
            const double excess = ellipse.MajorRadius() - ellipse.MinorRadius();
            if (excess <= resolution)
                curves.emplace_back(new Geom_Circle(ellipse.Position(), ellipse.MinorRadius() + excess / 2));
            else
                curves.emplace_back(new Geom_Ellipse(ellipse));
            break;
        }
        default:
            break;
        }
    return curves;
}

double parameterOf(const Handle(Geom_Curve) & curve, const gp_Pnt& point) {
    if (const auto line = Handle(Geom_Line)::DownCast(curve); !line.IsNull())
        return ElCLib::Parameter(line->Lin(), point);
    if (const auto circle = Handle(Geom_Circle)::DownCast(curve); !circle.IsNull())
        return ElCLib::Parameter(circle->Circ(), point);
    return ElCLib::Parameter(Handle(Geom_Ellipse)::DownCast(curve)->Elips(), point);
}

/// From an angle on to another one, counter-clockwise.
double angleFrom(double from, double to) {
    const double angle = std::fmod(to - from, turn);
    return angle < 0 ? angle + turn : angle;
}

bool passes(const Handle(Geom_Curve) & curve, const gp_Pnt& point, double resolution) {
    return curve->Value(parameterOf(curve, point)).Distance(point) <= resolution;
}

/// The piece of a curve from one of its points to another, on the side where a third one is.
CurvePiece pieceOf(const Handle(Geom_Curve) & curve, const std::array<gp_Pnt, 2>& ends,
                   const gp_Pnt& through) {
    CurvePiece piece{curve, parameterOf(curve, ends[0]), parameterOf(curve, ends[1])};
    if (!curve->IsPeriodic()) {
        if (piece.first <= piece.last) return piece;
        std::swap(piece.first, piece.last);
        return reversed(piece);
    }
    const double angle = angleFrom(piece.first, piece.last);
    if (angleFrom(piece.first, parameterOf(curve, through)) <= angle) {
        piece.last = piece.first + angle;
        return piece;
    }
    return reversed({curve, piece.last, piece.last + (turn - angle)});
}

bool isOn(const CurvePiece& piece, const std::array<SimpleSurface, 2>& surfaces, double tolerance) {
    for (const double t : parametersOf(piece, 2))
        for (const SimpleSurface& surface : surfaces)
            if (!(commonPoint(piece.at(t), {surface}).Distance(piece.at(t)) <= tolerance)) return false;
    return true;
}

} // namespace

CurvePiece reversed(const CurvePiece& piece) {
    CurvePiece result{piece.curve->Reversed(), piece.curve->ReversedParameter(piece.last),
                      piece.curve->ReversedParameter(piece.first)};
    if (!piece.curve->IsPeriodic()) return result;
    const double shift = turn * std::floor(result.first / turn);
    result.first -= shift;
    result.last -= shift;
    return result;
}

std::optional<CurvePiece> conicCurve(const std::array<SimpleSurface, 2>& surfaces,
                                     const std::array<gp_Pnt, 2>& ends, const gp_Pnt& through,
                                     double resolution) {
    if (ends[0].Distance(ends[1]) <= resolution) return std::nullopt;
    std::optional<CurvePiece> best;
    double distance = infinity;
    std::vector<Handle(Geom_Curve)> candidates = meetings(surfaces, resolution / 4);
    if (areOneRuledSurface(surfaces[0], surfaces[1], resolution / 4))
        candidates.emplace_back(new Geom_Line(ends[0], gp_Dir(ends[1].XYZ() - ends[0].XYZ())));
    for (const Handle(Geom_Curve) & curve : candidates) {
        if (!passes(curve, ends[0], resolution / 2) || !passes(curve, ends[1], resolution / 2)) continue;
        const CurvePiece piece = pieceOf(curve, ends, through);
        const double away = piece.middle().Distance(through);
        if (!isOn(piece, surfaces, resolution / 2) || away >= distance) continue;
        best = piece;
        distance = away;
    }
    return best;
}

std::optional<CurvePiece> continued(const CurvePiece& piece, const CurvePiece& after, double resolution) {
    if (piece.curve->DynamicType() != after.curve->DynamicType()) return std::nullopt;
    if (!piece.curve->IsKind(STANDARD_TYPE(Geom_Line)) && !piece.curve->IsPeriodic()) return std::nullopt;
    for (const double t : parametersOf(after, 2))
        if (!passes(piece.curve, after.at(t), resolution)) return std::nullopt;
    const bool isTurned = after.start().Distance(piece.end()) > after.end().Distance(piece.end());
    const double to = parameterOf(piece.curve, isTurned ? after.start() : after.end());
    CurvePiece result = piece;
    if (!piece.curve->IsPeriodic()) {
        result.last = to;
        if (!(result.last > piece.last)) return std::nullopt;
        return result;
    }
    const double more = angleFrom(piece.last, to);
    // The other way around it would be another piece.
    if (std::abs(more - (after.last - after.first)) > 1e-3 * more) return std::nullopt;
    result.last = piece.last + more;
    constexpr double open = 1e-3; // of a turn
    if (result.last - result.first > turn * (1 - open)) return std::nullopt;
    return result;
}

} // namespace qm

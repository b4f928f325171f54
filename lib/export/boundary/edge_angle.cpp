#include "export/boundary/edge_angle.h"

#include <GeomLProp_SLProps.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <numbers>

namespace qm {

std::optional<gp_Dir> normalAt(const EdgeSide& side, double parameter) {
    std::optional<gp_Dir> normal;
    if (const auto plane = Handle(Geom_Plane)::DownCast(side.surface); !plane.IsNull()) {
        normal = plane->Axis().Direction();
    } else {
        const gp_Pnt2d at = side.onFace->Value(parameter);
        constexpr double noTangent = 1e-12;
        GeomLProp_SLProps properties(side.surface, at.X(), at.Y(), 1, noTangent);
        if (!properties.IsNormalDefined()) return std::nullopt;
        normal = properties.Normal();
    }
    return side.reversed ? normal->Reversed() : *normal;
}

double largestAngle(const CurvePiece& curve, const std::array<EdgeSide, 2>& sides, double fromEnds) {
    constexpr int samples = 4; // in every knot interval
    double largest = 0;
    const double margin = fromEnds * (curve.last - curve.first);
    for (const double t : parametersOf(curve, samples)) {
        const double parameter = std::clamp(t, curve.first + margin, curve.last - margin);
        const auto one = normalAt(sides[0], parameter);
        const auto other = normalAt(sides[1], parameter);
        if (one && other) largest = std::max(largest, one->Angle(*other));
    }
    return largest * (180 / std::numbers::pi);
}

} // namespace qm

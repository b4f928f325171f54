#include "export/boundary/edge_angle.h"

#include <GeomLProp_SLProps.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>
#include <numbers>

namespace qm {

std::optional<gp_Dir> normalAt(const BoundaryFace& face, const BoundaryEdge& edge, std::size_t side,
                               double parameter) {
    std::optional<gp_Dir> normal;
    if (const auto plane = Handle(Geom_Plane)::DownCast(face.surface); !plane.IsNull()) {
        normal = plane->Axis().Direction();
    } else {
        const gp_Pnt2d at = parametersAt(face, edge, side, parameter);
        constexpr double noTangent = 1e-12;
        GeomLProp_SLProps properties(face.surface, at.X(), at.Y(), 1, noTangent);
        if (!properties.IsNormalDefined()) return std::nullopt;
        normal = properties.Normal();
    }
    return face.reversed ? normal->Reversed() : *normal;
}

double largestAngle(const BoundaryEdge& edge, const std::array<const BoundaryFace*, 2>& faces,
                    double fromEnds) {
    const CurvePiece& curve = edge.curve;
    constexpr int samples = 4; // in every knot interval
    double largest = 0;
    const double margin = fromEnds * (curve.last - curve.first);
    for (const double t : parametersOf(curve, samples)) {
        const double parameter = std::clamp(t, curve.first + margin, curve.last - margin);
        const auto one = normalAt(*faces[0], edge, 0, parameter);
        const auto other = normalAt(*faces[1], edge, 1, parameter);
        if (one && other) largest = std::max(largest, one->Angle(*other));
    }
    return largest * (180 / std::numbers::pi);
}

} // namespace qm

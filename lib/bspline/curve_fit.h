/// \file A spline curve with few control points within a tolerance of a polyline.
#pragma once

#include "bspline/closeness.h"
#include "bspline/spline_curve.h"

#include <optional>
#include <span>
#include <vector>

namespace qm {

/// The curve's derivative at a point of the polyline is to be orthogonal to a unit vector.
struct TangentPlane {
    int point = 0;
    Point normal{0, 0, 0};
    double tangency = 0.15; ///< the sine of the largest angle to which it may come
};

struct CurveFitInput {
    std::vector<Point> points;        ///< the polyline; point k lies at parameter k; at least two
    std::vector<Closeness> closeness; ///< at every point
    std::vector<int> fixed;           ///< inner points the curve must pass through
    Point startSlope{0, 0, 0};        ///< derivatives that the curve should have at its ends
    Point endSlope{0, 0, 0};          ///<
    std::vector<TangentPlane> planes; ///< at fixed points and at the ends
};

/// Least squares with the ends and the fixed points met exactly, starting with one cubic; intervals with too
/// large an error get knots until at every quarter of an edge the distance to the polyline's point of the
/// same parameter, or, where it slides, to the polyline's tangent there, is within the tolerance; then knots
/// that turn out not to be needed go. The tangents come near their planes, unless that cannot be done within
/// the tolerance. Always succeeds: in the end the space holds the polyline. \param exact  how far from a
/// fixed point the curve may pass for rounding's sake
[[nodiscard]] SplineCurve fitCurve(const CurveFitInput& input, double tolerance, double exact);

/// Like `fitCurve`, with given knots: those of a known fit and more; as many of the places as possible are
/// done without, tried in their order. None if not even all of them are enough.
[[nodiscard]] std::optional<SplineCurve> fitCurveOver(const CurveFitInput& input, double tolerance,
                                                      double exact, const SplineCurve& known,
                                                      std::span<const double> places);

/// Instead of a known fit without inner knots, one of a lower degree, though not below `least`, if it fits;
/// else the known one.
[[nodiscard]] SplineCurve withLeastDegree(const CurveFitInput& input, double tolerance, double exact,
                                          const SplineCurve& known, int least);

/// Over the knots of a known fit, the curve that comes as near to the tangents' planes as the tolerance
/// allows.
[[nodiscard]] SplineCurve inTangentPlanes(const CurveFitInput& input, double tolerance, double exact,
                                          const SplineCurve& known);

} // namespace qm

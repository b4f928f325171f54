/// \file A spline curve with few control points within a tolerance of a polyline.
#pragma once

#include "bspline/spline_curve.h"

#include <span>
#include <vector>

namespace qm {

struct CurveFitInput {
    std::vector<Point> points; ///< the polyline; point k lies at parameter k; at least two
    std::vector<int> fixed;    ///< inner points the curve must pass through
    Point startSlope{0, 0, 0}; ///< derivatives that the curve should have at its ends
    Point endSlope{0, 0, 0};   ///<
};

/// Least squares with the ends and the fixed points met exactly, starting with one cubic; intervals with too
/// large an error get knots until at every quarter of an edge the distance to the polyline's point of the
/// same parameter, or, if it slides, to the polyline's tangent there, is within the tolerance. Always
/// succeeds: in the end the space holds the polyline. \param exact  how far from a fixed point the curve may
/// pass for rounding's sake
[[nodiscard]] SplineCurve fitCurve(const CurveFitInput& input, double tolerance, double exact,
                                   bool slides = false);

} // namespace qm

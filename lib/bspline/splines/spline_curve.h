/// \file Cubic spline curves with clamped ends, and their exact restriction, refinement and joining.
#pragma once

#include "mesh/quad_mesh.h"

#include <span>
#include <vector>

namespace qm {

/// A cubic B-spline over [0, length]. Its first and last knot are fourfold, so it begins and ends at its
/// first and last control point. There are four more knots than points.
struct SplineCurve {
    std::vector<double> knots;
    std::vector<Point> points;
    int degree = 3; ///< less if the curve, then without inner knots, is known to be of a lower degree

    [[nodiscard]] double length() const { return knots.empty() ? 0 : knots.back(); }
};

[[nodiscard]] Point evaluate(const SplineCurve& curve, double t);

/// The same curve, on the whole or a part of its interval, over other knots: clamped ones that hold all of
/// the curve's own knots inside the part at least as often.
[[nodiscard]] SplineCurve withKnots(const SplineCurve& curve, const std::vector<double>& knots);

/// The part of the curve from `begin` to `end`, parameterised from 0.
[[nodiscard]] SplineCurve restricted(const SplineCurve& curve, double begin, double end);

/// The curve walked the other way.
[[nodiscard]] SplineCurve reversed(const SplineCurve& curve);

/// The Bezier curve with two, three or four control points, so of degree one, two or three, over [0, length]
/// and without inner knots.
[[nodiscard]] SplineCurve bezier(std::span<const Point> points, double length);

/// The control points of a curve without inner knots when it is written as one of the given degree, 1 to 3
/// and not below its own.
[[nodiscard]] std::vector<Point> degreeReduced(const SplineCurve& curve, int degree);

/// Curves end to end; each begins where the one before ends. A triple knot marks every joint.
[[nodiscard]] SplineCurve joined(std::span<const SplineCurve> curves);

} // namespace qm

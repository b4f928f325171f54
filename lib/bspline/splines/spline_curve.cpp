#include "bspline/splines/spline_curve.h"

#include "bspline/splines/blossom.h"

#include <algorithm>
#include <array>

namespace qm {
namespace {

/// The control point that belongs to three successive knots, whatever the knots around them, of the
/// polynomial around a parameter.
Point blossomAround(const SplineCurve& curve, double parameter, const std::array<double, 3>& arguments) {
    const std::size_t span = knotSpan(curve.knots, 3, parameter);
    std::array<Point, 4> points;
    std::copy_n(curve.points.begin() + static_cast<std::ptrdiff_t>(span - 3), points.size(), points.begin());
    return blossom<Point>(curve.knots, span, arguments, points);
}

} // namespace

Point evaluate(const SplineCurve& curve, double t) {
    return blossomAround(curve, t, {t, t, t});
}

SplineCurve withKnots(const SplineCurve& curve, const std::vector<double>& knots) {
    SplineCurve result;
    result.knots = knots;
    result.degree = curve.degree;
    result.points.reserve(knots.size() - 4);
    for (std::size_t k = 0; k + 4 < knots.size(); ++k) {
        std::size_t interval = k; // a non-empty one on which this control point counts
        while (interval < k + 3 && !(knots[interval] < knots[interval + 1]))
            ++interval;
        const double middle = (knots[interval] + knots[interval + 1]) / 2;
        result.points.push_back(blossomAround(curve, middle, {knots[k + 1], knots[k + 2], knots[k + 3]}));
    }
    return result;
}

SplineCurve restricted(const SplineCurve& curve, double begin, double end) {
    std::vector<double> knots(4, begin);
    const auto inner = std::ranges::upper_bound(curve.knots, begin);
    knots.insert(knots.end(), inner, std::lower_bound(inner, curve.knots.end(), end));
    knots.insert(knots.end(), 4, end);
    SplineCurve result = withKnots(curve, knots);
    for (double& knot : result.knots)
        knot -= begin;
    return result;
}

SplineCurve reversed(const SplineCurve& curve) {
    SplineCurve result;
    result.degree = curve.degree;
    result.points.assign(curve.points.rbegin(), curve.points.rend());
    result.knots.reserve(curve.knots.size());
    for (auto knot = curve.knots.rbegin(); knot != curve.knots.rend(); ++knot)
        result.knots.push_back(curve.length() - *knot);
    return result;
}

std::vector<Point> degreeReduced(const SplineCurve& curve, int degree) {
    const auto& p = curve.points;
    if (degree == 1) return {p[0], p[3]};
    if (degree == 2) return {p[0], (3.0 * (p[1] + p[2]) - p[0] - p[3]) / 4.0, p[3]};
    return p;
}

SplineCurve bezier(std::span<const Point> points, double length) {
    SplineCurve curve;
    curve.degree = static_cast<int>(points.size()) - 1;
    curve.knots = {0, 0, 0, 0, length, length, length, length};
    const Point& p = points.front();
    const Point& q = points.back();
    if (curve.degree == 1)
        curve.points = {p, (2.0 * p + q) / 3.0, (p + 2.0 * q) / 3.0, q};
    else if (curve.degree == 2)
        curve.points = {p, (p + 2.0 * points[1]) / 3.0, (2.0 * points[1] + q) / 3.0, q};
    else
        curve.points.assign(points.begin(), points.end());
    return curve;
}

SplineCurve joined(std::span<const SplineCurve> curves) {
    SplineCurve result = curves.front();
    if (curves.size() > 1) result.degree = 3;
    for (const SplineCurve& curve : curves.subspan(1)) {
        const double offset = result.length();
        result.knots.pop_back();
        for (std::size_t k = 4; k < curve.knots.size(); ++k)
            result.knots.push_back(curve.knots[k] + offset);
        result.points.insert(result.points.end(), curve.points.begin() + 1, curve.points.end());
    }
    return result;
}

} // namespace qm

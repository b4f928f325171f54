#include "bspline/curve_fit.h"

#include "bspline/curve_solver.h"
#include "bspline/knot_refinement.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace qm {
namespace {

/// Weights of the tangents' planes that are tried once there are enough knots.
constexpr std::array<double, 4> planeWeights = {1000, 30, 8, 2.5};

/// Takes out knots for as long as the curve still fits.
SplineCurve withoutNeedlessKnots(const CurveSolver& solver, SplineCurve curve) {
    for (std::size_t k = 4; k + 4 < curve.knots.size();) {
        std::vector<double> fewer = curve.knots;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        SplineCurve simpler = solver.attempt(fewer, searchWeight);
        if (solver.fits(simpler))
            curve = std::move(simpler);
        else
            ++k;
    }
    return curve;
}

std::optional<SplineCurve> refined(const CurveSolver& solver, double length, double planes,
                                   const KnotRules& rules) {
    std::vector<double> knots = bareKnots(length);
    while (true) {
        SplineCurve curve = solver.attempt(knots, planes);
        KnotRefinement refinement(knots, rules);
        if (!solver.mark(curve, refinement)) return withoutNeedlessKnots(solver, std::move(curve));
        const auto more = refinement.refined();
        if (more == knots) return std::nullopt;
        knots = more;
    }
}

} // namespace

std::optional<SplineCurve> fitCurveOver(const CurveFitInput& input, double tolerance, double exact,
                                        const SplineCurve& known, std::span<const double> places) {
    const CurveSolver solver(input, tolerance, exact, true);
    std::vector<double> more(places.begin(), places.end());
    std::sort(more.begin(), more.end());
    SplineCurve curve = solver.attempt(commonKnots(known.knots, more), searchWeight);
    if (!solver.fits(curve)) return std::nullopt;
    for (const double place : places)
        while (true) {
            std::vector<double> fewer = curve.knots;
            const auto knot = std::lower_bound(fewer.begin(), fewer.end(), place);
            if (knot == fewer.end() || *knot != place) break;
            fewer.erase(knot);
            SplineCurve simpler = solver.attempt(fewer, searchWeight);
            if (!solver.fits(simpler)) break;
            curve = std::move(simpler);
        }
    return curve;
}

SplineCurve withLeastDegree(const CurveFitInput& input, double tolerance, double exact,
                            const SplineCurve& known, int least) {
    const CurveSolver solver(input, tolerance, exact, true);
    const bool bare = known.points.size() == 4;
    for (int degree = least; bare && degree < 3; ++degree)
        if (SplineCurve curve = solver.attempt(known.knots, searchWeight, degree); solver.fits(curve))
            return curve;
    return known;
}

SplineCurve inTangentPlanes(const CurveFitInput& input, double tolerance, double exact,
                            const SplineCurve& known) {
    const CurveSolver solver(input, tolerance, exact, false);
    for (const double weight : planeWeights) {
        SplineCurve curve = solver.attempt(known.knots, weight, known.degree);
        if (solver.fits(curve)) return curve;
    }
    return known;
}

SplineCurve fitCurve(const CurveFitInput& input, double tolerance, double exact) {
    const auto length = static_cast<double>(input.points.size() - 1);
    const CurveSolver solver(input, tolerance, exact, true);
    if (auto curve = refined(solver, length, searchWeight, {finestKnots, false, solver.sharpPoints()}))
        return *curve;
    const CurveSolver close(input, tolerance, exact, false);
    if (auto curve = refined(close, length, 0, {})) return *curve;
    // Rounding alone can be in the way of conditions that a triple knot everywhere meets.
    SplineCurve polyline;
    polyline.knots.assign(4, 0);
    polyline.points.push_back(input.points.front());
    for (std::size_t k = 1; k < input.points.size(); ++k) {
        polyline.knots.insert(polyline.knots.end(), 3, static_cast<double>(k));
        const Point step = input.points[k] - input.points[k - 1];
        polyline.points.push_back(input.points[k - 1] + step / 3.0);
        polyline.points.push_back(input.points[k] - step / 3.0);
        polyline.points.push_back(input.points[k]);
    }
    polyline.knots.push_back(length);
    return polyline;
}

} // namespace qm

#include "bspline/curve_solver.h"

#include "bspline/curve_equations.h"
#include "bspline/design_matrix.h"
#include "bspline/eigen_point.h"
#include "bspline/slide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace qm {
namespace {

CurveWeights valuesOf(const BasisValues& basis) {
    return {basis.value[0], basis.value[1], basis.value[2], basis.value[3]};
}

CurveWeights derivativesOf(const BasisValues& basis) {
    return {basis.derivative[0], basis.derivative[1], basis.derivative[2], basis.derivative[3]};
}

std::array<Point, 3> axes() {
    return {Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
}

Point on(const SplineCurve& curve, const BasisValues& basis) {
    Point result{0, 0, 0};
    for (std::size_t k = 0; k < 4; ++k)
        result += basis.value[k] * curve.points[basis.first + k];
    return result;
}

/// Differences of the control points of a cubic that vanish if its degree is lower.
std::vector<CurveWeights> vanishing(int degree) {
    if (degree == 1) return {{1, -2, 1, 0}, {0, 1, -2, 1}};
    if (degree == 2) return {{-1, 3, -3, 1}};
    return {};
}

} // namespace

CurveSolver::CurveSolver(const CurveFitInput& input, double tolerance, double exact, bool nearPlanes)
    : input_(input), exact_(exact), nearPlanes_(nearPlanes), edges_(input.points.size() - 1),
      parameters_(sampleParameters(static_cast<int>(edges_), fitSteps)) {
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
        targets_.push_back(onPolyline(parameters_[k]));
        closeness_.push_back(closenessAt(parameters_[k]));
        closeness_.back().share *= tolerance;
        const double nearer = tolerance / closeness_.back().share;
        metrics_.emplace_back(nearer * nearer * metric(k));
    }
}

SplineCurve CurveSolver::attempt(const std::vector<double>& knots, double planes, int degree) const {
    constexpr int rounds = 4;
    constexpr double hopeless = 1.7; // an error that weights do not mend
    const auto table = basisTable(knots, 3, parameters_);
    std::vector<double> weights(parameters_.size(), 1);
    SplineCurve best;
    double least = 0;
    for (int round = 0; round < rounds; ++round) {
        SplineCurve curve = solve(knots, table, weights, planes, degree);
        double most = 0;
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            const double error = counted(k, on(curve, table[k]) - targets_[k]);
            weights[k] *= 0.1 + error;
            most = std::max(most, error);
        }
        if (round == 0 || most < least) {
            best = std::move(curve);
            least = most;
        }
        if (most <= 1 || most > hopeless) break;
    }
    return best;
}

bool CurveSolver::mark(const SplineCurve& curve, KnotRefinement& refinement) const {
    bool found = false;
    const auto table = basisTable(curve.knots, 3, parameters_);
    for (std::size_t k = 0; k < parameters_.size(); ++k) {
        const double error = counted(k, on(curve, table[k]) - targets_[k]);
        if (!(error <= 1)) {
            refinement.addError(parameters_[k], error);
            found = true;
        }
    }
    for (const int fixed : input_.fixed)
        if (!((evaluate(curve, fixed) - point(fixed)).norm() <= exact_)) {
            refinement.addKnot(fixed);
            found = true;
        }
    for (const TangentPlane& plane : input_.planes) {
        const Point tangent = derivative(curve, plane.point);
        if (!nearPlanes_ || std::abs(tangent | plane.normal) <= plane.tangency * tangent.norm()) continue;
        found = true;
        for (const double beside : {-0.25, 0.25})
            refinement.addError(std::clamp<double>(plane.point + beside, 0, static_cast<double>(edges_)), 1);
    }
    return found;
}

bool CurveSolver::fits(const SplineCurve& curve) const {
    KnotRefinement unused(curve.knots, {});
    return !mark(curve, unused);
}

std::vector<bool> CurveSolver::sharpPoints() const {
    constexpr double cosine = 0.75;
    std::vector<bool> sharp(edges_ + 1, false);
    for (std::size_t k = 1; k < edges_; ++k) {
        const Point before = input_.points[k] - input_.points[k - 1];
        const Point after = input_.points[k + 1] - input_.points[k];
        sharp[k] = (before | after) < cosine * before.norm() * after.norm();
    }
    return sharp;
}

Point CurveSolver::onPolyline(double t) const {
    const std::size_t edge = std::min(static_cast<std::size_t>(t), edges_ - 1);
    const double share = t - static_cast<double>(edge);
    return (1 - share) * input_.points[edge] + share * input_.points[edge + 1];
}

Closeness CurveSolver::closenessAt(double t) const {
    if (input_.closeness.empty()) return {1, false};
    const std::size_t edge = std::min(static_cast<std::size_t>(t), edges_ - 1);
    return between(input_.closeness[edge], input_.closeness[edge + 1], t - static_cast<double>(edge));
}

/// How much an error counts: little along the polyline, if it slides.
Eigen::Matrix3d CurveSolver::metric(std::size_t sample) const {
    const std::size_t edge = std::min(sample / fitSteps, edges_ - 1);
    const Point along = input_.points[edge + 1] - input_.points[edge];
    const double length = along.norm();
    const double slide = std::max(closeness_[sample].share / (curveSlide * length), leastSlideWeight);
    if (!closeness_[sample].slides || !(slide < 1)) return Eigen::Matrix3d::Identity();
    const Eigen::Vector3d direction = vector(along) / length;
    return Eigen::Matrix3d::Identity() - (1 - slide * slide) * direction * direction.transpose();
}

SplineCurve CurveSolver::solve(const std::vector<double>& knots, const std::vector<BasisValues>& table,
                               const std::vector<double>& weights, double planes, int degree) const {
    const std::size_t count = knots.size() - 4;
    CurveEquations equations(count);
    for (std::size_t k = 0; k < parameters_.size(); ++k)
        equations.add(table[k].first, valuesOf(table[k]), weights[k] * metrics_[k], targets_[k]);
    for (std::size_t k = 0; k < count; ++k)
        equations.pull(k, onPolyline((knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3));
    if (planes > 0) {
        constexpr double slopeWeight = 0.25;
        const BasisValues start = basisValues(knots, 3, 0);
        const BasisValues end = basisValues(knots, 3, static_cast<double>(edges_));
        const Eigen::Matrix3d metric = slopeWeight * slopeWeight * Eigen::Matrix3d::Identity();
        equations.add(start.first, derivativesOf(start), metric, input_.startSlope);
        equations.add(end.first, derivativesOf(end), metric, input_.endSlope);
        for (const TangentPlane& plane : input_.planes) {
            const BasisValues basis = basisValues(knots, 3, plane.point);
            const Eigen::Vector3d normal = vector(plane.normal);
            equations.add(basis.first, derivativesOf(basis), planes * planes * normal * normal.transpose(),
                          Point(0, 0, 0));
        }
    }
    const auto passThrough = [&](int fixed) {
        const BasisValues basis = basisValues(knots, 3, fixed);
        for (const Point& axis : axes())
            equations.require(basis.first, valuesOf(basis), axis, point(fixed) | axis);
    };
    for (const CurveWeights& difference : vanishing(degree))
        for (const Point& axis : axes())
            equations.require(0, difference, axis, 0);
    passThrough(0);
    for (const int fixed : input_.fixed)
        passThrough(fixed);
    passThrough(static_cast<int>(edges_));
    SplineCurve curve;
    curve.knots = knots;
    curve.points = equations.solve();
    curve.points.front() = input_.points.front();
    curve.points.back() = input_.points.back();
    return degree < 3 ? bezier(lowered(curve, degree), curve.length()) : curve;
}

/// The error at a sample, in tolerances; at a vertex of the polyline it counts across both edges.
double CurveSolver::counted(std::size_t sample, const Point& error) const {
    const double tolerance = closeness_[sample].share;
    const double distance = error.norm() / tolerance;
    if (!closeness_[sample].slides || distance <= 1) return distance;
    const std::size_t edge = std::min(sample / fitSteps, edges_ - 1);
    const std::size_t first = sample % fitSteps == 0 && edge > 0 ? edge - 1 : edge;
    double result = 0;
    for (std::size_t k = first; k <= edge; ++k) {
        const Point along = input_.points[k + 1] - input_.points[k];
        if (along.sqrnorm() == 0) return distance;
        const double slide = (error | along) / along.sqrnorm();
        const double off = (error - slide * along).norm();
        result = std::max({result, off / tolerance, std::abs(slide) / curveSlide});
    }
    return result;
}

} // namespace qm

#include "bspline/curve_fit.h"

#include "bspline/curve_equations.h"
#include "bspline/design_matrix.h"
#include "bspline/knot_refinement.h"
#include "bspline/slide.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>

namespace qm {
namespace {

Eigen::Vector3d vector(const Point& point) {
    return {point[0], point[1], point[2]};
}

CurveWeights valuesOf(const BasisValues& basis) {
    return {basis.value[0], basis.value[1], basis.value[2], basis.value[3]};
}

CurveWeights derivativesOf(const BasisValues& basis) {
    return {basis.derivative[0], basis.derivative[1], basis.derivative[2], basis.derivative[3]};
}

class CurveFit {
public:
    CurveFit(const CurveFitInput& input, double tolerance, double exact, bool slides, bool inPlanes)
        : input_(input), tolerance_(tolerance), exact_(exact), slides_(slides), inPlanes_(inPlanes),
          edges_(input.points.size() - 1), parameters_(sampleParameters(static_cast<int>(edges_), fitSteps)) {
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            targets_.push_back(onPolyline(parameters_[k]));
            metrics_.push_back(metric(k));
        }
    }

    /// The best curve over the knots; several times, with more weight where the error was large.
    [[nodiscard]] SplineCurve attempt(const std::vector<double>& knots) const {
        constexpr int rounds = 4;
        const auto table = basisTable(knots, 3, parameters_);
        std::vector<double> weights(parameters_.size(), 1);
        SplineCurve best;
        double least = 0;
        for (int round = 0; round < rounds; ++round) {
            SplineCurve curve = solve(knots, table, weights);
            double most = 0;
            for (std::size_t k = 0; k < parameters_.size(); ++k) {
                const double error = counted(k, on(curve, table[k]) - targets_[k]) / tolerance_;
                weights[k] *= 0.1 + error;
                most = std::max(most, error);
            }
            if (round == 0 || most < least) {
                best = std::move(curve);
                least = most;
            }
            if (most <= 1 || most > 3) break;
        }
        return best;
    }

    /// Marks where the tolerance is exceeded or a condition is missed. False if nowhere.
    bool mark(const SplineCurve& curve, KnotRefinement& refinement) const {
        bool found = false;
        const auto table = basisTable(curve.knots, 3, parameters_);
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
            const double error = counted(k, on(curve, table[k]) - targets_[k]);
            if (!(error <= tolerance_)) {
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
            if (!inPlanes_) break;
            constexpr double rounding = 1e-7;
            const Point tangent = derivative(curve, plane.point);
            if (std::abs(tangent | plane.normal) <= rounding * tangent.norm()) continue;
            found = true;
            for (const double beside : {-0.25, 0.25})
                refinement.addError(std::clamp<double>(plane.point + beside, 0, static_cast<double>(edges_)),
                                    tolerance_);
        }
        return found;
    }

    [[nodiscard]] bool fits(const SplineCurve& curve) const {
        KnotRefinement unused(curve.knots, {});
        return !mark(curve, unused);
    }

    /// Integers at which the polyline turns so much that no smooth curve should follow it.
    [[nodiscard]] std::vector<bool> sharpPoints() const {
        constexpr double cosine = 0.75;
        std::vector<bool> sharp(edges_ + 1, false);
        for (std::size_t k = 1; k < edges_; ++k) {
            const Point before = input_.points[k] - input_.points[k - 1];
            const Point after = input_.points[k + 1] - input_.points[k];
            sharp[k] = (before | after) < cosine * before.norm() * after.norm();
        }
        return sharp;
    }

private:
    [[nodiscard]] const Point& point(int k) const { return input_.points[static_cast<std::size_t>(k)]; }

    [[nodiscard]] Point onPolyline(double t) const {
        const std::size_t edge = std::min(static_cast<std::size_t>(t), edges_ - 1);
        const double share = t - static_cast<double>(edge);
        return (1 - share) * input_.points[edge] + share * input_.points[edge + 1];
    }

    static Point on(const SplineCurve& curve, const BasisValues& basis) {
        Point result{0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k)
            result += basis.value[k] * curve.points[basis.first + k];
        return result;
    }

    /// How much an error counts: little along the polyline, if it slides.
    [[nodiscard]] Eigen::Matrix3d metric(std::size_t sample) const {
        const std::size_t edge = std::min(sample / fitSteps, edges_ - 1);
        const Point along = input_.points[edge + 1] - input_.points[edge];
        const double length = along.norm();
        const double slide = std::max(tolerance_ / (curveSlide * length), leastSlideWeight);
        if (!slides_ || !(slide < 1)) return Eigen::Matrix3d::Identity();
        const Eigen::Vector3d direction = vector(along) / length;
        return Eigen::Matrix3d::Identity() - (1 - slide * slide) * direction * direction.transpose();
    }

    [[nodiscard]] SplineCurve solve(const std::vector<double>& knots, const std::vector<BasisValues>& table,
                                    const std::vector<double>& weights) const {
        const std::size_t count = knots.size() - 4;
        CurveEquations equations(count);
        for (std::size_t k = 0; k < parameters_.size(); ++k)
            equations.add(table[k].first, valuesOf(table[k]), weights[k] * metrics_[k], targets_[k]);
        for (std::size_t k = 0; k < count; ++k)
            equations.pull(k, onPolyline((knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3));
        if (inPlanes_) {
            constexpr double slopeWeight = 0.25;
            const BasisValues start = basisValues(knots, 3, 0);
            const BasisValues end = basisValues(knots, 3, static_cast<double>(edges_));
            const Eigen::Matrix3d metric = slopeWeight * slopeWeight * Eigen::Matrix3d::Identity();
            equations.add(start.first, derivativesOf(start), metric, input_.startSlope);
            equations.add(end.first, derivativesOf(end), metric, input_.endSlope);
            for (const TangentPlane& plane : input_.planes) {
                const BasisValues basis = basisValues(knots, 3, plane.point);
                equations.require(basis.first, derivativesOf(basis), plane.normal, 0);
            }
        }
        const auto passThrough = [&](int fixed) {
            const BasisValues basis = basisValues(knots, 3, fixed);
            for (unsigned c = 0; c < 3; ++c) {
                Point axis{0, 0, 0};
                axis[c] = 1;
                equations.require(basis.first, valuesOf(basis), axis, point(fixed)[c]);
            }
        };
        passThrough(0);
        for (const int fixed : input_.fixed)
            passThrough(fixed);
        passThrough(static_cast<int>(edges_));
        SplineCurve curve;
        curve.knots = knots;
        curve.points = equations.solve();
        curve.points.front() = input_.points.front();
        curve.points.back() = input_.points.back();
        return curve;
    }

    /// The error at a sample; at a vertex of the polyline it counts across both edges.
    [[nodiscard]] double counted(std::size_t sample, const Point& error) const {
        if (!slides_ || error.norm() <= tolerance_) return error.norm();
        const std::size_t edge = std::min(sample / fitSteps, edges_ - 1);
        const std::size_t first = sample % fitSteps == 0 && edge > 0 ? edge - 1 : edge;
        double result = 0;
        for (std::size_t k = first; k <= edge; ++k) {
            const Point along = input_.points[k + 1] - input_.points[k];
            if (along.sqrnorm() == 0) return error.norm();
            const double slide = (error | along) / along.sqrnorm();
            const double off = (error - slide * along).norm();
            result = std::max(result, countedError(off, std::abs(slide), curveSlide, tolerance_));
        }
        return result;
    }

    const CurveFitInput& input_;
    double tolerance_;
    double exact_;
    bool slides_;
    bool inPlanes_;
    std::size_t edges_;
    std::vector<double> parameters_;
    std::vector<Point> targets_;           ///< by sample
    std::vector<Eigen::Matrix3d> metrics_; ///< how much an error counts
};

/// Takes out knots for as long as the curve still fits, beginning in the middle of each run of attempts.
SplineCurve withoutNeedlessKnots(const CurveFit& fit, SplineCurve curve) {
    for (std::size_t k = 4; k + 4 < curve.knots.size();) {
        std::vector<double> fewer = curve.knots;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        SplineCurve simpler = fit.attempt(fewer);
        if (fit.fits(simpler))
            curve = std::move(simpler);
        else
            ++k;
    }
    return curve;
}

std::optional<SplineCurve> refined(const CurveFit& fit, double length, const KnotRules& rules) {
    std::vector<double> knots = bareKnots(length);
    while (true) {
        SplineCurve curve = fit.attempt(knots);
        KnotRefinement refinement(knots, rules);
        if (!fit.mark(curve, refinement)) return withoutNeedlessKnots(fit, std::move(curve));
        const auto more = refinement.refined();
        if (more == knots) return std::nullopt;
        knots = more;
    }
}

} // namespace

std::optional<SplineCurve> fitCurveOver(const CurveFitInput& input, double tolerance, double exact,
                                        bool slides, const SplineCurve& known,
                                        std::span<const double> places) {
    const CurveFit fit(input, tolerance, exact, slides, true);
    std::vector<double> more(places.begin(), places.end());
    std::sort(more.begin(), more.end());
    SplineCurve curve = fit.attempt(commonKnots(known.knots, more));
    if (!fit.fits(curve)) return std::nullopt;
    for (const double place : places)
        while (true) {
            std::vector<double> fewer = curve.knots;
            const auto knot = std::lower_bound(fewer.begin(), fewer.end(), place);
            if (knot == fewer.end() || *knot != place) break;
            fewer.erase(knot);
            SplineCurve simpler = fit.attempt(fewer);
            if (!fit.fits(simpler)) break;
            curve = std::move(simpler);
        }
    return curve;
}

SplineCurve fitCurve(const CurveFitInput& input, double tolerance, double exact, bool slides) {
    const auto length = static_cast<double>(input.points.size() - 1);
    const CurveFit smooth(input, tolerance, exact, slides, true);
    if (auto curve = refined(smooth, length, {finestKnots, false, smooth.sharpPoints()})) return *curve;
    const CurveFit close(input, tolerance, exact, slides, false);
    if (auto curve = refined(close, length, {})) return *curve;
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

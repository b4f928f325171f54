#include "bspline/splines/bezier_extraction.h"

#include "base/at.h"
#include "base/positions.h"
#include "bspline/splines/blossom.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace qm {
namespace {

/// Rows of weights.
using Weights = std::vector<std::vector<double>>;

/// a * x + b * y into x.
void mix(double a, std::vector<double>& x, double b, const std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = a * x[k] + b * y[k];
}

/// A Bezier point over [from, to] of the polynomial over knot interval `span`: weights of the control points
/// span - degree ... span.
std::vector<double> bezierPoint(std::span<const double> knots, int degree, std::size_t span, double from,
                                double to, int number) {
    std::vector<double> arguments(at(degree), from);
    std::fill_n(arguments.begin(), number, to);
    const BlossomWeights weights = blossomWeights(knots, span, arguments);
    return {weights.begin(), weights.end()};
}

/// The knots of a polynomial over [0, 1] whose control points are its Bezier points; interval `degree` of
/// them is not empty.
std::vector<double> bezierKnots(int degree) {
    std::vector<double> knots(2 * (at(degree) + 1), 0.0);
    std::fill(knots.begin() + degree + 1, knots.end(), 1.0);
    return knots;
}

/// The same polynomial's Bezier points of one degree more.
Weights elevated(const Weights& rows) {
    const std::size_t degree = rows.size();
    Weights result(degree + 1, std::vector<double>(rows[0].size(), 0.0));
    for (std::size_t i = 0; i <= degree; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(degree);
        if (i > 0) mix(1, result[i], share, rows[i - 1]);
        if (i < degree) mix(1, result[i], 1 - share, rows[i]);
    }
    return result;
}

void append(Weights rows, BezierExtraction& extraction) {
    while (static_cast<int>(rows.size()) <= extraction.degree)
        rows = elevated(rows);
    for (const auto& row : rows)
        extraction.weights.insert(extraction.weights.end(), row.begin(), row.end());
}

/// Bezier points over [0, 1] as weights of the values at equal steps.
Weights bezierThroughSteps(int steps) {
    const int n = steps + 1;
    Eigen::MatrixXd atSteps(n, n); // of Bernstein's polynomials
    for (int k = 0; k < n; ++k) {
        const double t = static_cast<double>(k) / steps;
        const std::vector<double> row = bezierPoint(bezierKnots(steps), steps, at(steps), t, t, 0);
        atSteps.row(k) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), n);
    }
    const Eigen::MatrixXd ofValues = atSteps.inverse();
    Weights rows(at(n), std::vector<double>(at(n)));
    for (int k = 0; k < n; ++k)
        Eigen::Map<Eigen::RowVectorXd>(rows[at(k)].data(), n) = ofValues.row(k);
    return rows;
}

} // namespace

std::span<const double> BezierExtraction::of(std::size_t interval) const {
    const std::size_t size = at(controls) * (at(degree) + 1);
    return std::span(weights).subspan(interval * size, size);
}

std::size_t BezierExtraction::intervalAt(double parameter) const {
    const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, parameter);
    return positionIn(breaks, after) - 1;
}

std::vector<double> differentKnots(std::span<const double> knots, int degree) {
    const std::size_t p = at(degree);
    std::vector<double> different(knots.begin() + degree,
                                  knots.begin() + static_cast<std::ptrdiff_t>(knots.size() - p));
    different.erase(std::unique(different.begin(), different.end()), different.end());
    return different;
}

std::vector<double> gridLines(int edges) {
    std::vector<double> lines(at(edges) + 1);
    std::iota(lines.begin(), lines.end(), 0);
    return lines;
}

BezierExtraction splineExtraction(std::span<const double> knots, int degree, std::vector<double> breaks,
                                  int elevatedTo) {
    BezierExtraction extraction{degree + 1, elevatedTo, std::move(breaks), {}, {}};
    for (std::size_t k = 0; k + 1 < extraction.breaks.size(); ++k) {
        const auto [from, to] = extraction.range(k);
        const std::size_t span = knotSpan(knots, degree, 0.5 * (from + to));
        Weights rows;
        for (int times = 0; times <= degree; ++times)
            rows.push_back(bezierPoint(knots, degree, span, from, to, times));
        extraction.first.push_back(span - at(degree));
        append(std::move(rows), extraction);
    }
    return extraction;
}

BezierExtraction latticeExtraction(int steps, std::vector<double> breaks, int elevatedTo) {
    BezierExtraction extraction{steps + 1, elevatedTo, std::move(breaks), {}, {}};
    const Weights ofWhole = bezierThroughSteps(steps);
    const std::vector<double> knots = bezierKnots(steps);
    for (std::size_t k = 0; k + 1 < extraction.breaks.size(); ++k) {
        const double begin = std::floor(0.5 * (extraction.breaks[k] + extraction.breaks[k + 1]));
        const double from = extraction.breaks[k] - begin;
        const double to = extraction.breaks[k + 1] - begin;
        Weights rows;
        for (int times = 0; times <= steps; ++times) {
            const std::vector<double> ofBezier = bezierPoint(knots, steps, at(steps), from, to, times);
            std::vector<double> row(ofWhole.size(), 0.0);
            for (std::size_t i = 0; i < row.size(); ++i)
                mix(1, row, ofBezier[i], ofWhole[i]);
            rows.push_back(std::move(row));
        }
        extraction.first.push_back(static_cast<std::size_t>(begin) * at(steps));
        append(std::move(rows), extraction);
    }
    return extraction;
}

} // namespace qm

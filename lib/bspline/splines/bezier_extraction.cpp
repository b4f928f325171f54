#include "bspline/splines/bezier_extraction.h"

#include "base/at.h"
#include "base/positions.h"
#include "bspline/splines/basis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace qm {
namespace {

/// Rows of weights.
using Weights = std::vector<std::vector<double>>;

Weights identity(std::size_t size) {
    Weights rows(size, std::vector<double>(size, 0.0));
    for (std::size_t i = 0; i < size; ++i)
        rows[i][i] = 1;
    return rows;
}

/// a * x + b * y into x.
void mix(double a, std::vector<double>& x, double b, const std::vector<double>& y) {
    for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = a * x[k] + b * y[k];
}

/// The polar form of a spline's polynomial over knot interval `span` at parameters that are `to` `times`
/// times and else `from`: as weights of the control points span - degree ... span.
std::vector<double> splineBlossom(std::span<const double> knots, int degree, std::size_t span, double from,
                                  double to, int times) {
    const std::size_t p = at(degree);
    Weights rows = identity(p + 1);
    for (std::size_t level = 1; level <= p; ++level) {
        const double t = static_cast<int>(level) <= times ? to : from;
        for (std::size_t i = p; i >= level; --i) {
            const double low = knots[span - p + i];
            const double high = knots[span + 1 + i - level];
            const double share = (t - low) / (high - low);
            mix(share, rows[i], 1 - share, rows[i - 1]);
        }
    }
    return rows[p];
}

/// The same of a polynomial over [0, 1] as weights of its Bezier points.
std::vector<double> bezierBlossom(int degree, double from, double to, int times) {
    const std::size_t p = at(degree);
    Weights rows = identity(p + 1);
    for (std::size_t level = 1; level <= p; ++level) {
        const double t = static_cast<int>(level) <= times ? to : from;
        for (std::size_t i = 0; i + level <= p; ++i)
            mix(1 - t, rows[i], t, rows[i + 1]);
    }
    return rows[0];
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
    const std::size_t n = at(steps) + 1;
    // Bernstein's polynomials at the steps; the inverse by Gauss and Jordan with pivots.
    Weights matrix;
    Weights inverse = identity(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double t = static_cast<double>(k) / steps;
        matrix.push_back(bezierBlossom(steps, t, t, 0));
    }
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row)
            if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column])) pivot = row;
        std::swap(matrix[pivot], matrix[column]);
        std::swap(inverse[pivot], inverse[column]);
        const double scale = 1 / matrix[column][column];
        mix(scale, matrix[column], 0, matrix[column]);
        mix(scale, inverse[column], 0, inverse[column]);
        for (std::size_t row = 0; row < n; ++row) {
            if (row == column) continue;
            const double factor = -matrix[row][column];
            mix(1, matrix[row], factor, matrix[column]);
            mix(1, inverse[row], factor, inverse[column]);
        }
    }
    return inverse;
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

std::vector<double> mergedBreaks(std::span<const double> a, std::span<const double> b) {
    std::vector<double> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    std::ranges::sort(all);
    constexpr double apart = 1e-9;
    const auto near = [](double x, double y) { return y - x < apart; };
    all.erase(std::unique(all.begin(), all.end(), near), all.end());
    return all;
}

BezierExtraction splineExtraction(std::span<const double> knots, int degree, std::vector<double> breaks,
                                  int elevatedTo) {
    BezierExtraction extraction{degree + 1, elevatedTo, std::move(breaks), {}, {}};
    for (std::size_t k = 0; k + 1 < extraction.breaks.size(); ++k) {
        const double from = extraction.breaks[k];
        const double to = extraction.breaks[k + 1];
        const std::size_t span = knotSpan(knots, degree, 0.5 * (from + to));
        Weights rows;
        for (int times = 0; times <= degree; ++times)
            rows.push_back(splineBlossom(knots, degree, span, from, to, times));
        extraction.first.push_back(span - at(degree));
        append(std::move(rows), extraction);
    }
    return extraction;
}

BezierExtraction latticeExtraction(int steps, std::vector<double> breaks, int elevatedTo) {
    BezierExtraction extraction{steps + 1, elevatedTo, std::move(breaks), {}, {}};
    const Weights ofWhole = bezierThroughSteps(steps);
    for (std::size_t k = 0; k + 1 < extraction.breaks.size(); ++k) {
        const double begin = std::floor(0.5 * (extraction.breaks[k] + extraction.breaks[k + 1]));
        const double from = extraction.breaks[k] - begin;
        const double to = extraction.breaks[k + 1] - begin;
        Weights rows;
        for (int times = 0; times <= steps; ++times) {
            const std::vector<double> ofBezier = bezierBlossom(steps, from, to, times);
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

/// \file From control points to Bernstein's form, interval by interval, along one direction.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

/// Over each of several intervals a spline is one polynomial; its Bezier points are fixed combinations of the
/// control points that influence it there.
struct BezierExtraction {
    int controls = 0;               ///< how many control points influence an interval
    int degree = 0;                 ///< of the Bezier form
    std::vector<double> breaks;     ///< ends of the intervals, ascending; one more than intervals
    std::vector<std::size_t> first; ///< of every interval: its first control point
    std::vector<double> weights;    ///< of every interval degree + 1 rows of `controls` weights

    [[nodiscard]] std::size_t intervals() const { return first.size(); }
    /// The ends of an interval.
    [[nodiscard]] std::array<double, 2> range(std::size_t interval) const {
        return {breaks[interval], breaks[interval + 1]};
    }
    /// Row by row.
    [[nodiscard]] std::span<const double> of(std::size_t interval) const;
    /// The interval with the parameter; the nearest one if it is outside.
    [[nodiscard]] std::size_t intervalAt(double parameter) const;
};

/// The different knots of a domain, its ends among them.
[[nodiscard]] std::vector<double> differentKnots(std::span<const double> knots, int degree);

/// 0, 1 ... edges: the parameters of a patch's grid lines.
[[nodiscard]] std::vector<double> gridLines(int edges);

/// Of a spline.
/// \param breaks  within its domain, all its different knots among them
/// \param elevatedTo  degree of the Bezier form, at least that of the spline
[[nodiscard]] BezierExtraction splineExtraction(std::span<const double> knots, int degree,
                                                std::vector<double> breaks, int elevatedTo);

/// Of the polynomials of degree `steps` through values at `steps` steps of every unit interval, which have
/// the values at its ends in common.
/// \param breaks  from 0 to a whole number, all whole numbers between among them
[[nodiscard]] BezierExtraction latticeExtraction(int steps, std::vector<double> breaks, int elevatedTo);

} // namespace qm

/// \file Blossoms, also called polar forms, of the polynomials of a spline (docs/METHOD.md#de-boor-1978).
#pragma once

#include "bspline/splines/basis.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace qm {

/// The blossom of the polynomial over knot interval `span`, by de Boor's algorithm with one argument a step.
/// At successive knots of a refinement it is a control point of the refined spline, at equal arguments the
/// value there.
/// \param arguments  as many as the degree
/// \param points     the control points span - degree ... span; written over
template <class Value>
[[nodiscard]] Value blossom(std::span<const double> knots, std::size_t span,
                            std::span<const double> arguments, std::span<Value> points) {
    const std::size_t degree = arguments.size();
    for (std::size_t step = 1; step <= degree; ++step)
        for (std::size_t k = degree; k >= step; --k) {
            const double left = knots[span - degree + k];
            const double right = knots[span + 1 + k - step];
            const double share = (arguments[step - 1] - left) / (right - left);
            points[k] = (1 - share) * points[k - 1] + share * points[k];
        }
    return points[degree];
}

/// By control point.
using BlossomWeights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, maxDegree + 1, 1>;

/// The weights of these control points in the blossom.
[[nodiscard]] BlossomWeights blossomWeights(std::span<const double> knots, std::size_t span,
                                            std::span<const double> arguments);

} // namespace qm

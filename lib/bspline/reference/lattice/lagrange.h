/// \file Polynomials through equally spaced points.
#pragma once

#include "base/at.h"

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace qm {

/// Polynomials of higher degree through equally spaced points oscillate too much.
constexpr int maxSteps = 16;

/// The value of a function of one parameter, and its first two derivatives.
using Jet = std::array<double, 3>;

/// The jets of the weights of points, in their order; those of points that there are not are 0.
using LagrangeWeights = std::array<Jet, maxSteps + 1>;

/// The weights of steps + 1 equally spaced points in the jet of the polynomial through them.
/// \param steps      from 1 to maxSteps
/// \param parameter  0 at the first point, 1 at the last
[[nodiscard]] LagrangeWeights lagrange(int steps, double parameter);

/// A function's values for all numbers of steps, beginning with 1.
template <class Function> auto forAllSteps(const Function& function) {
    std::vector<decltype(function(1))> values;
    for (int steps = 1; steps <= maxSteps; ++steps)
        values.push_back(function(steps));
    return values;
}

/// The same weights at the first point (end 0) or the last one (end 1), computed once.
[[nodiscard]] const LagrangeWeights& lagrangeAtEnd(int steps, std::size_t end);

/// The derivative of the polynomial through steps + 1 points at the first one (end 0) or the last (end 1).
/// \param point  called with an int, k: the point after k steps, a vector of three coordinates
template <class PointAt>
[[nodiscard]] auto derivativeAtEnd(int steps, std::size_t end, const PointAt& point) {
    const LagrangeWeights& weights = lagrangeAtEnd(steps, end);
    std::decay_t<decltype(point(0))> sum(0, 0, 0);
    for (int k = 0; k <= steps; ++k)
        sum += weights[at(k)][1] * point(k);
    return sum;
}

} // namespace qm

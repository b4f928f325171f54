/// \file Polynomials through equally spaced points.
#pragma once

#include <array>
#include <cstddef>
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

} // namespace qm

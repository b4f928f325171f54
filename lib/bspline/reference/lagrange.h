/// \file Polynomials through equally spaced points.
#pragma once

#include <array>

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

} // namespace qm

/// \file The B-spline basis over any knots, clamped or repeated or neither (docs/METHOD.md#de-boor-1978).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

constexpr int maxDegree = 9;

/// The degree of a spline over clamped knots: one less than the multiplicity of the first.
[[nodiscard]] int clampedDegree(std::span<const double> knots);

/// The basis functions that do not vanish at a parameter: numbers first ... first + degree, with their
/// values and first derivatives.
struct BasisValues {
    std::size_t first = 0;
    std::array<double, maxDegree + 1> value{};
    std::array<double, maxDegree + 1> derivative{};
};

/// Smallest and largest parameter: knots [degree] and [size - degree - 1].
[[nodiscard]] std::array<double, 2> domain(std::span<const double> knots, int degree);

/// The non-empty knot interval [k, k + 1) that contains the parameter; the last one contains its end too.
/// Parameters outside the domain count as its nearest end.
[[nodiscard]] std::size_t knotSpan(std::span<const double> knots, int degree, double parameter);

/// \param parameter  outside the domain the end intervals' polynomials go on
[[nodiscard]] BasisValues basisValues(std::span<const double> knots, int degree, double parameter);

/// `basisValues` at each of several parameters.
[[nodiscard]] std::vector<BasisValues> basisTable(std::span<const double> knots, int degree,
                                                  std::span<const double> parameters);

} // namespace qm

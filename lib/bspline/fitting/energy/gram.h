/// \file Integrals of products of cubic B-splines and of their derivatives, interval by interval.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// The integrals over an interval on which each of the four B-splines that do not vanish is one polynomial.
struct GramPiece {
    std::size_t first = 0; ///< index of the first of the four B-splines
    std::size_t quad = 0;  ///< the unit interval that contains this one
    Matrix4 values{};      ///< integrals of B_i B_k
    Matrix4 slopes{};      ///< integrals of B_i' B_k'
    Matrix4 bends{};       ///< integrals of B_i'' B_k''
};

/// The intervals into which the knots and the whole numbers divide the domain of a clamped knot vector that
/// begins with 0.
[[nodiscard]] std::vector<GramPiece> gramPieces(std::span<const double> knots);

} // namespace qm

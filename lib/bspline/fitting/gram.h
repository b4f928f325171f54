/// \file Integrals of products of cubic B-splines and of their derivatives, piece by piece.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace qm {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// The integrals over an interval within which all four B-splines that do not vanish there are polynomials.
struct GramPiece {
    std::size_t first = 0; ///< of the four
    std::size_t quad = 0;  ///< the unit interval that it lies in
    Matrix4 values{};      ///< of B_i B_k
    Matrix4 slopes{};      ///< of B_i' B_k'
    Matrix4 bends{};       ///< of B_i'' B_k''
};

/// The domain cut at clamped knots, which begin with 0, and at whole numbers.
[[nodiscard]] std::vector<GramPiece> gramPieces(std::span<const double> knots);

} // namespace qm

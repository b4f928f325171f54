/// \file Integrals of products of B-splines and of their derivatives.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace qm {

/// A symmetric matrix with three diagonals beside its own: entry (i, i + d) at [i][d].
using BandMatrix = std::vector<std::array<double, 4>>;

/// For cubics over clamped knots: the integrals of B_i B_k, B_i' B_k' and B_i'' B_k''.
[[nodiscard]] std::array<BandMatrix, 3> gramMatrices(std::span<const double> knots);

} // namespace qm

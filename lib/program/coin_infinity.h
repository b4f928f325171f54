/// \file Infinity as the solvers of COIN-OR know it.
#pragma once

#include <coin/CoinFinite.hpp>

#include <cmath>

namespace qm {

/// A bound of a row or column, with the solvers' number for infinity.
inline double coinBound(double bound) {
    return std::isinf(bound) ? std::copysign(COIN_DBL_MAX, bound) : bound;
}

} // namespace qm

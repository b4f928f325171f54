/// \file The number that is larger than all others, with which a search for the smallest begins.
#pragma once

#include <limits>

namespace qm {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace qm

/// \file Points that equations keep equal, each set of them as one point.
#pragma once

#include "bspline/network/border_strip.h"

#include <cstddef>
#include <vector>

namespace qm {

struct TiedPoints {
    std::vector<std::size_t> setOf;    ///< by point
    std::vector<double> sizes;         ///< by set: its number of points
    std::vector<LinearForm> equations; ///< all but those that tie points, in the numbers of sets
};

/// \param count      number of points
/// \param equations  in the numbers of points, all equal to zero; those like x - y = 0 tie two
[[nodiscard]] TiedPoints tiedPoints(std::size_t count, const std::vector<LinearForm>& equations);

} // namespace qm

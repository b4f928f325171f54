/// \file Which points of a grid are next to one another.
#pragma once

#include <cstddef>

namespace qm {

/// Calls a function with every two neighbours in a row or column, the lower number first, which ascends.
/// \param columns  how many points a row has; they are numbered row by row
/// \param count    of all points, in full rows
template <class Function>
void forGridNeighbours(std::size_t columns, std::size_t count, const Function& function) {
    for (std::size_t k = 0; k < count; ++k) {
        if ((k + 1) % columns != 0) function(k, k + 1);
        if (k + columns < count) function(k, k + columns);
    }
}

} // namespace qm

/// \file Removes what is no longer needed from the lists of a boundary.
#pragma once

#include "export/boundary/boundary.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace qm {

/// Keeps what is marked, and says where it has gone.
template <class Value>
std::vector<std::size_t> keepMarked(std::vector<Value>& values, const std::vector<bool>& isKept) {
    std::vector<std::size_t> numbers(values.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        numbers[k] = count;
        if (!isKept[k]) continue;
        if (count != k) values[count] = std::move(values[k]);
        ++count;
    }
    values.resize(count);
    return numbers;
}

/// Drops edges that no face uses, and vertices without edges.
void dropUnused(Boundary& boundary);

} // namespace qm

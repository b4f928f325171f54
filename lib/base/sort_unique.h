/// \file Lists of values as sets.
#pragma once

#include <algorithm>

namespace qm {

/// Sorts values, and removes all but one of those that are equal.
template <class Values> void sortUnique(Values& values) {
    std::sort(values.begin(), values.end()); // OpenMesh's ids are less ordered than std::ranges asks
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace qm

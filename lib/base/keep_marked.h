/// \file Lists of which a part is kept.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace qm {

/// Keeps the values that are marked, in their order.
/// \return of every place before, the place where its value has gone
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

} // namespace qm

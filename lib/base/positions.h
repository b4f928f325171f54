/// \file Positions and counts in arrays as unsigned numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>

namespace qm {

/// \return the index that an iterator points to; the size of the array for its end
template <std::ranges::random_access_range Range>
[[nodiscard]] constexpr std::size_t positionIn(const Range& array,
                                               std::ranges::iterator_t<const Range> place) {
    return static_cast<std::size_t>(place - std::ranges::begin(array));
}

/// \return the number of elements equal to a value
template <std::ranges::input_range Range, class Value>
[[nodiscard]] constexpr std::size_t countIn(const Range& array, const Value& value) {
    return static_cast<std::size_t>(std::ranges::count(array, value));
}

/// \return the number of elements for which a condition holds
template <std::ranges::input_range Range, class Condition>
[[nodiscard]] constexpr std::size_t countWhere(const Range& array, const Condition& holds) {
    return static_cast<std::size_t>(std::ranges::count_if(array, holds));
}

} // namespace qm

/// \file Values of a certain rank, in linear time. What is passed is put into another order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace qm {

/// \param rank  counted from 0 for the smallest; there are more values
[[nodiscard]] inline double valueOfRank(std::vector<double>& values, std::size_t rank) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::ranges::nth_element(values, place);
    return *place;
}

/// The larger one of the two in the middle; 0 if there are no values.
[[nodiscard]] inline double median(std::vector<double>& values) {
    return values.empty() ? 0 : valueOfRank(values, values.size() / 2);
}

/// Times the median of sizes: the standard deviation, if they are those of a normal distribution.
constexpr double deviationByMedian = 1.4826;

/// The value up to which a share of all lies; 0 if there are none.
[[nodiscard]] inline double quantile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    return valueOfRank(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

} // namespace qm

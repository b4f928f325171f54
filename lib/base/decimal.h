/// \file Whole numbers of any size as decimal digits, for those who only hand them on: big_count.h takes the
/// compiler long.
#pragma once

#include <span>
#include <string>

namespace qm {

/// The product of numbers without a sign; 1 of none.
[[nodiscard]] std::string decimalProduct(std::span<const std::string> factors);

} // namespace qm

/// \file Whole numbers of any size as decimal digits, for code that only passes them on: big_count.h is slow
/// to compile.
#pragma once

#include <span>
#include <string>

namespace qm {

/// The product of non-negative numbers; 1 if there are none.
[[nodiscard]] std::string decimalProduct(std::span<const std::string> factors);

} // namespace qm

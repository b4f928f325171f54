/// \file Numbers as bytes in files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace qm {

/// Appends a number, its lowest byte first.
template <class Number>
requires std::is_arithmetic_v<Number>
void appendBytes(std::string& bytes, Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

/// The number with which bytes begin; there are enough of them.
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] Number numberFrom(std::string_view bytes, std::endian order = std::endian::little) {
    std::array<char, sizeof(Number)> raw;
    bytes.copy(raw.data(), raw.size());
    if (order != std::endian::native) std::ranges::reverse(raw);
    return std::bit_cast<Number>(raw);
}

} // namespace qm

/// \file Numbers as little-endian bytes.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <string>
#include <utility>

namespace qm {

template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void appendBytes(std::string& bytes, Number number) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if constexpr (std::endian::native == std::endian::big)
        for (std::size_t k = 0; k < raw.size() / 2; ++k)
            std::swap(raw[k], raw[raw.size() - 1 - k]);
    bytes.append(raw.data(), raw.size());
}

} // namespace qm

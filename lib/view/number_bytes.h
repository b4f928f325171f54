/// \file Numbers as few bytes, little-endian, and bytes as text, for pages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace qm {

/// Four bytes each.
[[nodiscard]] std::string floatBytes(const std::vector<float>& values);

/// Every number's difference from the one before, zigzag (0, -1, 1, -2, ... as 0, 1, 2, 3, ...), seven bits a
/// byte from the lowest on; all bytes of a number but its last have their highest bit set.
[[nodiscard]] std::string differenceBytes(const std::vector<std::int64_t>& values);

/// Two bytes each: multiples of `unit`, the largest of which is 65534; 65535 is NaN.
struct RoughNumbers {
    std::string bytes;
    double unit = 1;
};
/// \param values  not negative; what is infinite counts as the largest number
[[nodiscard]] RoughNumbers roughNumbers(const std::vector<float>& values);

/// Bytes in base64.
[[nodiscard]] std::string base64(std::string_view bytes);

} // namespace qm

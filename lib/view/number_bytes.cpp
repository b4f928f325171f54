#include "view/number_bytes.h"

#include "base/bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace qm {

std::string floatBytes(const std::vector<float>& values) {
    static_assert(std::endian::native == std::endian::little, "pages hold little-endian numbers");
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::string differenceBytes(const std::vector<std::int64_t>& values) {
    std::string bytes;
    std::int64_t before = 0;
    for (const std::int64_t value : values) {
        const std::int64_t difference = value - before;
        auto rest =
            (static_cast<std::uint64_t>(difference) << 1U) ^ static_cast<std::uint64_t>(difference >> 63U);
        for (; rest > 127; rest >>= 7U)
            bytes += static_cast<char>((rest & 127U) | 128U);
        bytes += static_cast<char>(rest);
        before = value;
    }
    return bytes;
}

RoughNumbers roughNumbers(const std::vector<float>& values) {
    constexpr std::uint16_t none = 65535;
    constexpr double highest = none - 1;
    float largest = 0;
    for (const float value : values) // not NaN: what is no larger than it stays
        largest = std::max(largest, std::min(value, std::numeric_limits<float>::max()));
    RoughNumbers result;
    if (largest > 0) result.unit = largest / highest;
    for (const float value : values) {
        const double share = std::clamp(value / result.unit, 0.0, highest);
        appendBytes(result.bytes, std::isnan(value) ? none : static_cast<std::uint16_t>(std::lround(share)));
    }
    return result;
}

} // namespace qm

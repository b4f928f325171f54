#include "document/json/json.h"

#include <cmath>
#include <limits>

namespace qm {

std::optional<std::int64_t> wholeNumber(const Json& value) {
    switch (value.type()) {
    case Json::value_t::number_integer:
        return value.get<std::int64_t>();
    case Json::value_t::number_unsigned: {
        const auto number = value.get<std::uint64_t>();
        if (number > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return {};
        return static_cast<std::int64_t>(number);
    }
    case Json::value_t::number_float: {
        constexpr double limit = 9007199254740992; // 2^53: all whole numbers up to here are exact doubles
        const double number = value.get<double>();
        if (!(std::abs(number) <= limit) || number != std::floor(number)) return {};
        return static_cast<std::int64_t>(number);
    }
    default:
        return {};
    }
}

} // namespace qm

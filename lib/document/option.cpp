#include "document/option.h"

#include "document/number_text.h"

#include <cctype>
#include <cmath>

namespace qm {

namespace {

/// For people: whole numbers in full, others to six digits.
std::string limitText(double limit) {
    char buffer[maxNumberText];
    constexpr double longest = 1e15;
    const bool whole = limit == std::floor(limit) && std::abs(limit) < longest;
    const auto end =
        whole ? std::to_chars(buffer, buffer + maxNumberText, limit, std::chars_format::fixed)
              : std::to_chars(buffer, buffer + maxNumberText, limit, std::chars_format::general, 6);
    return {buffer, end.ptr};
}

} // namespace

std::string rangeText(const Range& range) {
    const bool bounded = std::isfinite(range.max);
    if (std::isfinite(range.min))
        return bounded ? limitText(range.min) + " to " + limitText(range.max)
                       : "at least " + limitText(range.min);
    return bounded ? "at most " + limitText(range.max) : "";
}

std::string keyOf(std::string_view optionName) {
    std::string key;
    bool capital = false;
    for (const char c : optionName) {
        if (c != '-') key += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = c == '-';
    }
    return key;
}

} // namespace qm

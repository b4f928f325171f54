#include "mesh/files/text_lines.h"

#include "base/error.h"

#include <algorithm>

namespace qm {

void TextLines::fail(const std::string& what, const char* remedy) const {
    throw Error(place(), what, remedy);
}

bool isTiny(std::string_view number) {
    const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
    const std::string_view digits = number.substr(0, mark);
    const std::string_view exponent = number.substr(std::min(mark + 1, number.size()));
    // In floating point, as an exponent may be as large as its type allows.
    const auto point = static_cast<double>(std::min(digits.find('.'), digits.size()));
    const auto firstDigit = static_cast<double>(digits.find_first_of("123456789"));
    return point - firstDigit + static_cast<double>(readFileNumber<std::int64_t>(exponent).value_or(0)) < 0;
}

std::string inQuotes(std::string_view word) {
    constexpr std::size_t longest = 20;
    std::string shown(word.substr(0, longest));
    std::ranges::replace_if(
        shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return '"' + shown + (word.size() > longest ? "...\"" : "\"");
}

} // namespace qm

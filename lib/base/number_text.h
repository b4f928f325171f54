/// \file Numbers as text: the shortest text that reads back as the same number, in any locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>

namespace qm {

/// Appends a finite number.
/// \param format  of std::to_chars, for texts other than the shortest
template <class Number, class... Format>
void appendNumber(std::string& text, Number value, Format... format) {
    std::array<char, 40> buffer; // enough for any 64-bit integer and, unless it is fixed, any double
    text.append(buffer.data(),
                std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...).ptr);
}

template <class Number> [[nodiscard]] std::string numberText(Number value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

/// A number for people to read: whole numbers in full, others with so many significant digits.
[[nodiscard]] inline std::string roundedText(double value, int digits = 6) {
    constexpr double longest = 1e15;
    std::string text;
    if (value == std::floor(value) && std::abs(value) < longest)
        appendNumber(text, value, std::chars_format::fixed);
    else
        appendNumber(text, value, std::chars_format::general, digits);
    return text;
}

/// "1 hole", "2 holes".
/// \param several  the noun's plural, if that is not the noun with an s
[[nodiscard]] inline std::string countText(std::size_t count, const std::string& noun,
                                           const std::string& several = {}) {
    return std::to_string(count) + " " + (count == 1 ? noun : several.empty() ? noun + "s" : several);
}

/// Turns -0 into 0, so that a number keeps its text when other programs rewrite a document.
[[nodiscard]] inline double withoutSignOfZero(double value) {
    return value == 0 ? 0.0 : value;
}

/// Reads a whole text as a finite number; false if it is anything else.
template <class Number> [[nodiscard]] bool parseNumber(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    return failure == std::errc{} && stop == end && std::isfinite(static_cast<double>(value));
}

} // namespace qm

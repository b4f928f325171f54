/// \file Numbers as text: the shortest that reads back as the same number, whatever the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace qm {

/// Enough characters for any double or 64-bit integer.
constexpr std::size_t maxNumberText = 32;

/// Writes a finite number to a buffer of `maxNumberText` characters. Whole numbers have no point and zero no
/// sign, so that a number keeps its text when other programs rewrite a document.
/// \return the end of the text
inline char* writeNumber(char* buffer, double value) {
    return std::to_chars(buffer, buffer + maxNumberText, value == 0 ? 0.0 : value).ptr;
}

[[nodiscard]] inline std::string numberText(double value) {
    char buffer[maxNumberText];
    return {buffer, writeNumber(buffer, value)};
}

/// Reads a whole text as a number; false if it is anything else, or not finite.
template <class Number> [[nodiscard]] bool parseNumber(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(text.data(), end, value);
    return failure == std::errc{} && stop == end && std::isfinite(static_cast<double>(value));
}

} // namespace qm

#include "document/options/option.h"

#include "base/number_text.h"

#include <cctype>
#include <cmath>

namespace qm {

std::string rangeText(const Range& range) {
    const bool bounded = std::isfinite(range.max);
    if (std::isfinite(range.min))
        return bounded ? roundedText(range.min) + " to " + roundedText(range.max)
                       : "at least " + roundedText(range.min);
    return bounded ? "at most " + roundedText(range.max) : "";
}

std::string lengthText(const Length& length) {
    return numberText(length.value) + (length.percent ? "%" : "");
}

bool parseLength(std::string_view text, Length& length) {
    const bool percent = text.ends_with('%');
    if (percent) text.remove_suffix(1);
    double value = 0;
    if (!parseNumber(text, value) || value < 0) return false;
    length = {value, percent};
    return true;
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

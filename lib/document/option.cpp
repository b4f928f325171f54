#include "document/option.h"

#include "base/number_text.h"

#include <cctype>
#include <cmath>

namespace qm {

std::string rangeText(const Range& range) {
    const bool bounded = std::isfinite(range.most);
    if (std::isfinite(range.least))
        return bounded ? roundedText(range.least) + " to " + roundedText(range.most)
                       : "at least " + roundedText(range.least);
    return bounded ? "at most " + roundedText(range.most) : "";
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

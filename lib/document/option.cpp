#include "document/option.h"

#include "document/number_text.h"

#include <cctype>
#include <cmath>

namespace qm {

std::string rangeText(const Range& range) {
    const bool bounded = std::isfinite(range.most);
    if (std::isfinite(range.least))
        return bounded ? numberText(range.least) + " to " + numberText(range.most)
                       : "at least " + numberText(range.least);
    return bounded ? "at most " + numberText(range.most) : "";
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

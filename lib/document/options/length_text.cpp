#include "document/options/length_text.h"

#include "base/number_text.h"

namespace qm {

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

} // namespace qm

#include "document/tolerance_text.h"

#include "base/number_text.h"

namespace qm {

std::string toleranceText(const Tolerance& tolerance) {
    return numberText(tolerance.value) + (tolerance.percent ? "%" : "");
}

bool parseTolerance(std::string_view text, Tolerance& tolerance) {
    const bool percent = text.ends_with('%');
    if (percent) text.remove_suffix(1);
    double value = 0;
    if (!parseNumber(text, value) || value <= 0) return false;
    tolerance = {value, percent};
    return true;
}

} // namespace qm

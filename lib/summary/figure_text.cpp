#include "summary/figure_text.h"

#include "base/number_text.h"

#include <cmath>

namespace qm {

std::string figureText(double value) {
    std::string text;
    if (std::abs(value) >= 100 && std::abs(value) < 1e9)
        appendNumber(text, std::round(value), std::chars_format::fixed, 0);
    else
        appendNumber(text, value, std::chars_format::general, std::abs(value) < 1e-6 ? 2 : 3);
    return text;
}

std::string pointText(const Point& point, double extent) {
    // Beside the others, nothing is what rounding left of zero.
    const double nothing = 1e-12 * point.norm();
    // So many digits behind the point as tell places on the model apart, where three do not.
    const int digits = extent > 0 ? static_cast<int>(std::ceil(2 - std::log10(extent))) : 0;
    std::string text;
    for (const double coordinate : point) {
        const double value = std::abs(coordinate) <= nothing ? 0 : coordinate;
        text += text.empty() ? "(" : ", ";
        if (digits > 0 && digits < 9 && std::abs(value) >= 10 * extent)
            appendNumber(text, value, std::chars_format::fixed, digits);
        else
            text += figureText(value);
    }
    return text + ")";
}

std::string countText(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace qm

#include "summary/figure_text.h"

#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace qm {

std::string figureText(double value) {
    constexpr double whole = 100, longest = 1e9; // from three digits on no fraction; from ten on an exponent
    constexpr double tiny = 1e-6;                // an exponent stands there anyway: two digits are enough
    std::string text;
    if (std::abs(value) >= whole && std::abs(value) < longest)
        appendNumber(text, std::round(value), std::chars_format::fixed, 0);
    else
        appendNumber(text, value, std::chars_format::general, std::abs(value) < tiny ? 2 : 3);
    return text;
}

std::array<std::string, 2> figuresApart(double one, double other) {
    constexpr int usual = 3, longest = 17; // digits; no double has more
    std::array texts{figureText(one), figureText(other)};
    for (int digits = usual + 1; texts[0] == texts[1] && digits <= longest; ++digits)
        texts = {roundedText(one, digits), roundedText(other, digits)};
    return texts;
}

std::string pointText(const Point& point, double extent) {
    constexpr double rounding = 1e-12; // what it leaves of zero, beside the other coordinates and the model
    const double nothing = rounding * std::max(point.norm(), extent);
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

std::string placeText(const SurfacePlace& place, double extent) {
    return "in patch " + std::to_string(place.place.patch) + " at " + pointText(place.point, extent);
}

} // namespace qm

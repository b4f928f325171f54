#include "export/quads.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

/// \param hue, saturation, value  0 to 1
Colour fromHue(double hue, double saturation, double value) {
    Colour colour;
    for (std::size_t k = 0; k < 3; ++k) {
        const double shifted = std::fmod(hue * 6 + std::array{0.0, 4.0, 2.0}[k], 6.0);
        const double share = std::clamp(std::abs(shifted - 3) - 1, 0.0, 1.0);
        colour[k] = static_cast<std::uint8_t>(std::lround(255 * value * (1 - saturation * (1 - share))));
    }
    return colour;
}

} // namespace

std::vector<Colour> segmentColours(const Layout& layout, const Surfaces* surfaces, ColourBy by) {
    std::vector<Colour> colours;
    if (by == ColourBy::deviation) {
        for (const Deviation& deviation : surfaces->ofPatch) {
            const double largest = surfaces->deviation.max;
            const double share = largest > 0 ? std::clamp(deviation.max / largest, 0.0, 1.0) : 0;
            colours.push_back(fromHue((1 - share) * 2 / 3, 1, 1));
        }
        return colours;
    }
    // Steps of the golden section keep the hues of any few successive numbers far apart.
    constexpr double goldenSection = 0.6180339887498949;
    // Hues come back after some seven, a little darker each time, so that light falls on pale colours only.
    constexpr std::size_t hues = 7, shades = 3;
    constexpr double saturation = 0.55, brightest = 0.95, darker = 0.15;
    for (std::size_t k = 0; k < layout.segments.size(); ++k) {
        const auto number = static_cast<double>(k);
        const double value = brightest - darker * static_cast<double>(k / hues % shades);
        colours.push_back(fromHue(std::fmod(number * goldenSection, 1.0), saturation, value));
    }
    return colours;
}

} // namespace qm

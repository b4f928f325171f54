#include "view/view_options.h"

#include "base/error.h"
#include "base/joined.h"
#include "base/number_text.h"

#include <algorithm>
#include <cmath>

namespace qm {
namespace {

std::vector<std::string> split(const std::string& text, char mark) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == mark)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

} // namespace

std::vector<std::string> allLayerNames() {
    std::vector<std::string> names(faceLayerNames.begin(), faceLayerNames.end());
    names.insert(names.end(), lineLayerNames.begin(), lineLayerNames.end());
    return names;
}

std::vector<std::string> parseLayers(const std::string& text) {
    const std::vector<std::string> known = allLayerNames();
    std::vector<std::string> names;
    for (std::string& name : split(text, ',')) {
        if (name.empty()) continue;
        if (std::ranges::find(known, name) == known.end())
            throw Error("", "there is no layer " + name, "Give some of " + joined(known));
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

std::array<double, 3> parseDirection(const std::string& text) {
    const auto parts = split(text, ',');
    std::array<double, 3> direction{};
    bool sound = parts.size() == direction.size();
    for (std::size_t k = 0; sound && k < direction.size(); ++k)
        sound = parseNumber(parts[k], direction[k]);
    // The page squares the numbers.
    constexpr double tiny = 1e-100;
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (!sound || length < tiny || length > 1 / tiny)
        throw Error("", "'" + text + "' is no direction", "Give three numbers, such as 1,-1,0.5");
    return direction;
}

std::optional<Section> parseSection(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto parts = split(text, ':');
    const std::string axes = "xyz";
    Section section;
    section.axis = axes.find(parts[0]);
    if (parts[0].size() != 1 || section.axis >= axes.size() || parts.size() > 2 ||
        (parts.size() == 2 && !parseNumber(parts[1], section.share)) ||
        !(section.share >= 0 && section.share <= 1))
        throw Error("", "'" + text + "' is no section",
                    "Give an axis and a share of the extent, such as x:0.5");
    return section;
}

PictureSize parseSize(const std::string& text) {
    constexpr int min = 16;
    constexpr int max = 8192;
    const auto parts = split(text, 'x');
    PictureSize size;
    if (parts.size() != 2 || !parseNumber(parts[0], size.width) || !parseNumber(parts[1], size.height) ||
        std::min(size.width, size.height) < min || std::max(size.width, size.height) > max)
        throw Error("", "'" + text + "' is no size of a picture", "Give width and height, such as 1200x900");
    return size;
}

} // namespace qm

#include "mesh/soup/soup.h"

#include "base/positions.h"

#include <algorithm>

namespace qm {
namespace {

using Numbers = std::vector<std::uint32_t>;

std::string place(const char* what, std::size_t k, const Numbers& numbers, const Numbers& lines) {
    std::string text = what + std::to_string(k < numbers.size() ? numbers[k] : k);
    if (k < lines.size()) text += " (line " + std::to_string(lines[k]) + ")";
    return text;
}

} // namespace

std::size_t Soup::faceOf(std::size_t corner) const {
    return positionIn(faceBegins, std::ranges::upper_bound(faceBegins, corner)) - 1;
}

void Soup::endFace(std::uint32_t line) {
    faceBegins.push_back(corners.size());
    if (line > 0) faceLines.push_back(line);
}

std::size_t Soup::pointNumber(std::size_t k) const {
    return k < pointNumbers.size() ? pointNumbers[k] : k;
}

std::string Soup::pointPlace(std::size_t k) const {
    return place("vertex ", k, pointNumbers, pointLines);
}

std::string Soup::facePlace(std::size_t k) const {
    return place("face ", k, faceNumbers, faceLines);
}

} // namespace qm

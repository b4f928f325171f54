#include "mesh/soup.h"

namespace qm {
namespace {
std::string place(const char* what, std::size_t k, const std::vector<std::uint32_t>& lines) {
    std::string text = what + std::to_string(k);
    if (k < lines.size()) text += " (line " + std::to_string(lines[k]) + ")";
    return text;
}
} // namespace

void Soup::endFace(std::uint32_t line) {
    faceBegins.push_back(corners.size());
    if (line > 0) faceLines.push_back(line);
}

std::string Soup::pointPlace(std::size_t k) const {
    return place("vertex ", k, pointLines);
}
std::string Soup::facePlace(std::size_t k) const {
    return place("face ", k, faceLines);
}

} // namespace qm

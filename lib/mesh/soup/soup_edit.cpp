#include "base/at.h"
#include "base/keep_marked.h"
#include "base/positions.h"
#include "mesh/soup/soup_repairs.h"

#include <algorithm>

namespace qm {

void writeDown(std::vector<std::uint32_t>& numbers, std::size_t count) {
    for (std::size_t k = numbers.size(); k < count; ++k)
        numbers.push_back(static_cast<std::uint32_t>(k));
}

std::size_t keepFaces(Soup& soup, const std::vector<bool>& kept) {
    const std::size_t going = countIn(kept, false);
    if (going == 0) return 0;
    writeDown(soup.faceNumbers, soup.faceCount());
    (void)keepMarked(soup.faceNumbers, kept);
    (void)keepMarked(soup.faceLines, kept);
    std::size_t faces = 0;
    auto corners = soup.corners.begin();
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (!kept[k]) continue;
        corners = std::ranges::copy(soup.face(k), corners).out; // never moves corners towards the end
        soup.faceBegins[++faces] = positionIn(soup.corners, corners);
    }
    soup.corners.erase(corners, soup.corners.end());
    soup.faceBegins.resize(faces + 1);
    return going;
}

std::size_t mergePoints(Soup& soup, const std::vector<std::size_t>& target) {
    std::vector<bool> isKept;
    isKept.reserve(target.size());
    for (const std::size_t other : target)
        isKept.push_back(other == isKept.size());
    writeDown(soup.pointNumbers, soup.points.size());
    (void)keepMarked(soup.pointNumbers, isKept);
    (void)keepMarked(soup.pointLines, isKept);
    const std::vector<std::size_t> places = keepMarked(soup.points, isKept);
    for (std::int64_t& corner : soup.corners)
        corner = static_cast<std::int64_t>(places[target[at(corner)]]);
    return target.size() - soup.points.size();
}

} // namespace qm

#include "base/at.h"
#include "base/positions.h"
#include "mesh/soup/soup_repairs.h"

#include <algorithm>

namespace qm {
namespace {

/// Extends a list of numbers in the file, which may be implicit, to the given length.
void writeDown(std::vector<std::uint32_t>& numbers, std::size_t count) {
    for (std::size_t k = numbers.size(); k < count; ++k)
        numbers.push_back(static_cast<std::uint32_t>(k));
}

template <class Value> void moveEntry(std::vector<Value>& values, std::size_t from, std::size_t to) {
    if (from < values.size()) values[to] = values[from];
}

template <class Value> void shorten(std::vector<Value>& values, std::size_t size) {
    if (values.size() > size) values.resize(size);
}

} // namespace

std::size_t keepFaces(Soup& soup, const std::vector<bool>& kept) {
    const std::size_t going = countIn(kept, false);
    if (going == 0) return 0;
    writeDown(soup.faceNumbers, soup.faceCount());
    std::size_t faces = 0;
    auto corners = soup.corners.begin();
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (!kept[k]) continue;
        corners = std::ranges::copy(soup.face(k), corners).out; // never moves corners towards the end
        moveEntry(soup.faceLines, k, faces);
        moveEntry(soup.faceNumbers, k, faces);
        soup.faceBegins[++faces] = positionIn(soup.corners, corners);
    }
    soup.corners.erase(corners, soup.corners.end());
    shorten(soup.faceBegins, faces + 1);
    shorten(soup.faceLines, faces);
    shorten(soup.faceNumbers, faces);
    return going;
}

std::size_t mergePoints(Soup& soup, const std::vector<std::size_t>& target) {
    std::vector<std::int64_t> newIndex(target.size());
    writeDown(soup.pointNumbers, soup.points.size());
    std::size_t points = 0;
    for (std::size_t k = 0; k < target.size(); ++k) {
        if (target[k] != k) {
            newIndex[k] = newIndex[target[k]];
            continue;
        }
        moveEntry(soup.points, k, points);
        moveEntry(soup.pointLines, k, points);
        moveEntry(soup.pointNumbers, k, points);
        newIndex[k] = static_cast<std::int64_t>(points++);
    }
    shorten(soup.points, points);
    shorten(soup.pointLines, points);
    shorten(soup.pointNumbers, points);
    for (std::int64_t& corner : soup.corners)
        corner = newIndex[at(corner)];
    return target.size() - points;
}

} // namespace qm

#include "mesh/files/read_triangles.h"

#include "base/at.h"
#include "base/error.h"
#include "base/groups.h"
#include "mesh/soup/soup.h"
#include "mesh/soup/validate.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace qm {
namespace {

/// For every point, the first point with the same coordinates.
std::vector<std::uint32_t> firstEqual(const std::vector<Point>& points) {
    using Entry = std::pair<Point, std::uint32_t>;
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (const Point& point : points)
        entries.emplace_back(point, static_cast<std::uint32_t>(entries.size()));
    std::sort(entries.begin(), entries.end());
    std::vector<std::uint32_t> first(points.size());
    forEachGroup(entries, &Entry::first, [&](std::span<const Entry> group) {
        for (const Entry& entry : group)
            first[entry.second] = group.front().second;
    });
    return first;
}

} // namespace

Triangles readTriangles(std::string_view bytes, std::string_view name) {
    const Soup soup = readSoup(bytes, name, 3);
    validatePolygons(soup);
    const std::vector<std::uint32_t> first = firstEqual(soup.points);
    std::vector<int> numbers(soup.points.size(), -1); // in the order in which triangles first use the points
    Triangles result;
    const auto numberOf = [&](std::uint32_t point) {
        int& number = numbers[point];
        if (number < 0) {
            number = static_cast<int>(result.points.size());
            result.points.push_back(soup.points[point]);
        }
        return number;
    };
    for (std::size_t face = 0; face < soup.faceCount(); ++face) {
        const auto corners = soup.face(face);
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const std::uint32_t a = first[at(corners[0])], b = first[at(corners[k - 1])],
                                c = first[at(corners[k])];
            if (a != b && b != c && c != a) result.faces.push_back({numberOf(a), numberOf(b), numberOf(c)});
        }
    }
    if (result.faces.empty())
        throw Error("", "none of its triangles has three different corners", "Use another copy of the file");
    return result;
}

} // namespace qm

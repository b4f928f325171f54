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

/// Numbers the points in the order in which triangles first use them.
class Builder {
public:
    explicit Builder(const Soup& soup)
        : soup_(soup), first_(firstEqual(soup.points)), numbers_(soup.points.size(), -1) {}

    Triangles run() {
        for (std::size_t face = 0; face < soup_.faceCount(); ++face) {
            const auto corners = soup_.face(face);
            for (std::size_t k = 2; k < corners.size(); ++k)
                add({corners[0], corners[k - 1], corners[k]});
        }
        if (result_.faces.empty())
            throw Error("", "none of its triangles has three different corners",
                        "Use another copy of the file");
        return std::move(result_);
    }

private:
    void add(const std::array<std::int64_t, 3>& corners) {
        std::array<std::uint32_t, 3> points{};
        std::ranges::transform(corners, points.begin(), [&](std::int64_t k) { return first_[at(k)]; });
        if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) return;
        auto& face = result_.faces.emplace_back();
        std::ranges::transform(points, face.begin(), [&](std::uint32_t k) { return numberOf(k); });
    }

    int numberOf(std::uint32_t point) {
        int& number = numbers_[point];
        if (number < 0) {
            number = static_cast<int>(result_.points.size());
            result_.points.push_back(soup_.points[point]);
        }
        return number;
    }

    const Soup& soup_;
    std::vector<std::uint32_t> first_;
    std::vector<int> numbers_;
    Triangles result_;
};

} // namespace

Triangles readTriangles(std::string_view bytes, std::string_view name) {
    const Soup soup = readSoup(bytes, name, 3);
    validatePolygons(soup);
    return Builder(soup).run();
}

} // namespace qm

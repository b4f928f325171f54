#include "mesh/repair.h"

#include "base/error.h"
#include "mesh/soup_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <unordered_map>

namespace qm {
namespace {

std::size_t at(std::int64_t index) {
    return static_cast<std::size_t>(index);
}

/// Finds an earlier point close to a new one, through a hash of cells as wide as the tolerance.
class PointGrid {
public:
    PointGrid(const std::vector<Point>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

    /// The first point within the tolerance that was kept, or this one, which is kept then.
    std::size_t findOrKeep(std::size_t k) {
        const auto cell = cellOf(points_[k]);
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if (const auto found = cells_.find(hash({cell[0] + x, cell[1] + y, cell[2] + z}));
                        found != cells_.end())
                        for (const std::size_t other : found->second)
                            if ((points_[other] - points_[k]).norm() <= tolerance_) return other;
        cells_[hash(cell)].push_back(k);
        return k;
    }

private:
    using Cell = std::array<double, 3>; // whole numbers, which doubles hold without overflow

    [[nodiscard]] Cell cellOf(const Point& point) const {
        const double width = tolerance_ > 0 ? tolerance_ : 1;
        return {std::floor(point[0] / width), std::floor(point[1] / width), std::floor(point[2] / width)};
    }

    static std::size_t hash(const Cell& cell) {
        std::size_t value = 0;
        for (const double coordinate : cell)
            value = value * 0x9e3779b97f4a7c15ULL + std::hash<double>{}(coordinate);
        return value;
    }

    const std::vector<Point>& points_;
    double tolerance_;
    std::unordered_map<std::size_t, std::vector<std::size_t>> cells_;
};

double diagonal(const std::vector<Point>& points) {
    if (points.empty()) return 0;
    Point low = points.front(), high = low;
    for (const Point& point : points) {
        low.minimize(point);
        high.maximize(point);
    }
    return (high - low).norm();
}

std::size_t weld(Soup& soup) {
    PointGrid grid(soup.points, 1e-9 * diagonal(soup.points));
    std::vector<std::int64_t> newIndex(soup.points.size());
    std::vector<Point> points;
    std::vector<std::uint32_t> lines;
    for (std::size_t k = 0; k < soup.points.size(); ++k) {
        const std::size_t kept = grid.findOrKeep(k);
        newIndex[k] = kept == k ? static_cast<std::int64_t>(points.size()) : newIndex[kept];
        if (kept != k) continue;
        points.push_back(soup.points[k]);
        if (k < soup.pointLines.size()) lines.push_back(soup.pointLines[k]);
    }
    for (std::int64_t& corner : soup.corners)
        corner = newIndex[at(corner)];
    const std::size_t welded = soup.points.size() - points.size();
    soup.points = std::move(points);
    soup.pointLines = std::move(lines);
    return welded;
}

/// Keeps the quads for which `keep` holds. \return how many went
template <class Keep> std::size_t filterFaces(Soup& soup, const Keep& keep) {
    Soup kept;
    for (std::size_t k = 0; k < soup.faceCount(); ++k) {
        std::array<std::int64_t, 4> corners;
        std::ranges::copy(soup.face(k), corners.begin());
        std::ranges::sort(corners);
        if (!keep(corners)) continue;
        kept.corners.insert(kept.corners.end(), soup.face(k).begin(), soup.face(k).end());
        kept.endFace(k < soup.faceLines.size() ? soup.faceLines[k] : 0);
    }
    const std::size_t dropped = soup.faceCount() - kept.faceCount();
    soup.corners = std::move(kept.corners);
    soup.faceBegins = std::move(kept.faceBegins);
    soup.faceLines = std::move(kept.faceLines);
    return dropped;
}

/// For every face whether it must be reversed, so that neighbours agree and the fewest of each component are.
class Orientation {
public:
    explicit Orientation(const Soup& soup) : soup_(soup), neighbours_(soup.faceCount()) {
        const SoupEdges edges = findEdges(soup);
        for (std::size_t k = 0; k < edges.count(); ++k) {
            const auto sides = edges.edge(k);
            if (sides.size() != 2) continue; // more faces than two: validation will refuse it
            const bool agree = sideFrom(soup, sides[0]) != sideFrom(soup, sides[1]);
            neighbours_[sides[0] / 4].push_back({sides[1] / 4, agree});
            neighbours_[sides[1] / 4].push_back({sides[0] / 4, agree});
        }
    }

    std::vector<bool> find() {
        std::vector<signed char> reversed(soup_.faceCount(), -1);
        std::vector<bool> result(soup_.faceCount(), false);
        for (std::size_t start = 0; start < reversed.size(); ++start) {
            if (reversed[start] >= 0) continue;
            const std::vector<std::size_t> component = spread(start, reversed);
            const auto turned = static_cast<std::size_t>(
                std::ranges::count_if(component, [&](std::size_t face) { return reversed[face] == 1; }));
            const bool minority = 2 * turned <= component.size();
            for (const std::size_t face : component)
                result[face] = (reversed[face] == 1) == minority;
        }
        return result;
    }

private:
    struct Neighbour {
        std::size_t face;
        bool agrees;
    };

    std::vector<std::size_t> spread(std::size_t start, std::vector<signed char>& reversed) const {
        std::vector<std::size_t> component{start};
        reversed[start] = 0;
        for (std::size_t next = 0; next < component.size(); ++next)
            for (const auto& [face, agrees] : neighbours_[component[next]]) {
                const auto wanted = static_cast<signed char>(agrees ? reversed[component[next]]
                                                                    : 1 - reversed[component[next]]);
                if (reversed[face] < 0) {
                    reversed[face] = wanted;
                    component.push_back(face);
                } else if (reversed[face] != wanted) {
                    throw Error(soup_.facePlace(face), "the faces cannot be oriented consistently",
                                "the surface has one side only, like a Moebius strip; cut it open");
                }
            }
        return component;
    }

    const Soup& soup_;
    std::vector<std::vector<Neighbour>> neighbours_;
};

std::size_t orient(Soup& soup) {
    const std::vector<bool> reverse = Orientation(soup).find();
    for (std::size_t k = 0; k < reverse.size(); ++k)
        if (reverse[k]) { // the first vertex stays the first
            const auto first = soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.faceBegins[k]);
            std::swap(first[1], first[3]);
        }
    return static_cast<std::size_t>(std::ranges::count(reverse, true));
}

} // namespace

RepairReport repairSoup(Soup& soup) {
    RepairReport report;
    report.weldedVertices = weld(soup);
    report.degenerateFaces = filterFaces(
        soup, [](const auto& corners) { return std::ranges::adjacent_find(corners) == corners.end(); });
    std::set<std::array<std::int64_t, 4>> seen;
    report.duplicateFaces =
        filterFaces(soup, [&](const auto& corners) { return seen.insert(corners).second; });
    report.flippedFaces = orient(soup);
    return report;
}

} // namespace qm

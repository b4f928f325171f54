#include "base/at.h"
#include "mesh/bounding_box.h"
#include "mesh/soup/soup_edges.h"
#include "mesh/soup/soup_repairs.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace qm {
namespace {

namespace index = boost::geometry::index;

std::size_t cornerAt(const Soup& soup, Side side) {
    return at(soup.corners[side]);
}

double toleranceOf(const Soup& soup) {
    const auto point = [&](std::int64_t corner) -> const Point& { return soup.points[at(corner)]; };
    return 1e-9 * boundingBoxOf(soup.corners, point).size().max();
}

/// By vertex: the sides that begin there.
std::vector<std::vector<Side>> starsOf(const Soup& soup) {
    std::vector<std::vector<Side>> stars(soup.points.size());
    for (Side side = 0; side < soup.corners.size(); ++side)
        stars[cornerAt(soup, side)].push_back(side);
    return stars;
}

std::vector<bool> borderVertices(const Soup& soup) {
    std::vector<bool> border(soup.points.size(), false);
    const SoupEdges edges = findEdges(soup);
    for (std::size_t k = 0; k < edges.count(); ++k)
        if (const auto sides = edges.edge(k); sides.size() == 1) {
            border[cornerAt(soup, sides[0])] = true;
            border[cornerAt(soup, nextSide(sides[0]))] = true;
        }
    return border;
}

/// A search tree of points with their numbers.
class PointTree {
public:
    PointTree(const std::vector<Point>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

    void add(std::size_t k) { tree_.insert({treePoint(points_[k]), k}); }

    /// The lowest accepted point at the place of point k; k itself if there is none.
    template <class Accept> [[nodiscard]] std::size_t find(std::size_t k, const Accept& accept) const {
        const Point reach(tolerance_, tolerance_, tolerance_);
        const Box box(treePoint(points_[k] - reach), treePoint(points_[k] + reach));
        std::size_t found = k;
        for (auto entry = tree_.qbegin(index::intersects(box)); entry != tree_.qend(); ++entry)
            if (const std::size_t other = entry->second;
                other < found && (points_[other] - points_[k]).max_abs() <= tolerance_ && accept(other))
                found = other;
        return found;
    }

private:
    using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
    using Box = boost::geometry::model::box<TreePoint>;

    static TreePoint treePoint(const Point& point) { return {point[0], point[1], point[2]}; }

    const std::vector<Point>& points_;
    double tolerance_;
    index::rtree<std::pair<TreePoint, std::size_t>, index::linear<16>> tree_;
};

std::vector<std::size_t> identity(std::size_t count) {
    std::vector<std::size_t> target(count);
    std::iota(target.begin(), target.end(), std::size_t{0});
    return target;
}

/// Decides quad by quad. Vertices of the faces around a collapsed quad are excluded from further collapses.
class Collapser {
public:
    explicit Collapser(const Soup& soup)
        : soup_(soup), stars_(starsOf(soup)), border_(borderVertices(soup)), tolerance_(toleranceOf(soup)),
          touched_(soup.points.size(), false) {
        result_.faceStays.assign(soup.faceCount(), true);
        result_.target = identity(soup.points.size());
    }

    Collapses run() {
        for (Side side = 0; side < soup_.corners.size(); ++side)
            if (side % 4 < 2 && canCollapse(side)) collapse(side);
        return std::move(result_);
    }

private:
    /// \param side  begins at one of the two opposite corners
    [[nodiscard]] bool canCollapse(Side side) const {
        const std::size_t a = cornerAt(soup_, side), c = cornerAt(soup_, side ^ 2U);
        return (soup_.points[a] - soup_.points[c]).max_abs() <= tolerance_ && !touched_[a] && !touched_[c] &&
               !(border_[a] && border_[c]) && shareOnly(side, a, c);
    }

    /// Whether the two vertices share no face except this one, and no neighbours except its other two
    /// corners.
    [[nodiscard]] bool shareOnly(Side side, std::size_t a, std::size_t c) const {
        std::vector<std::size_t> around;
        for (const Side out : stars_[a]) {
            around.push_back(cornerAt(soup_, nextSide(out)));
            around.push_back(cornerAt(soup_, previousSide(out)));
            if (out / 4 != side / 4)
                for (Side other = out & ~3U; other <= (out | 3U); ++other)
                    if (cornerAt(soup_, other) == c) return false;
        }
        std::ranges::sort(around);
        const std::size_t b = cornerAt(soup_, nextSide(side)), d = cornerAt(soup_, previousSide(side));
        return std::ranges::all_of(stars_[c], [&](Side out) {
            for (const std::size_t neighbour :
                 {cornerAt(soup_, nextSide(out)), cornerAt(soup_, previousSide(out))})
                if (neighbour != b && neighbour != d && std::ranges::binary_search(around, neighbour))
                    return false;
            return true;
        });
    }

    void collapse(Side side) {
        const auto [kept, gone] = std::minmax({cornerAt(soup_, side), cornerAt(soup_, side ^ 2U)});
        result_.target[gone] = kept;
        result_.faceStays[side / 4] = false;
        for (const std::size_t vertex : {kept, gone})
            for (const Side out : stars_[vertex])
                for (Side other = out & ~3U; other <= (out | 3U); ++other)
                    touched_[cornerAt(soup_, other)] = true;
    }

    const Soup& soup_;
    std::vector<std::vector<Side>> stars_;
    std::vector<bool> border_;
    double tolerance_;
    std::vector<bool> touched_;
    Collapses result_;
};

} // namespace

std::vector<std::size_t> weldTargets(const Soup& soup) {
    const std::vector<bool> border = borderVertices(soup);
    const auto stars = starsOf(soup);
    PointTree tree(soup.points, toleranceOf(soup));
    std::vector<std::size_t> target = identity(soup.points.size());
    for (std::size_t k = 0; k < target.size(); ++k) {
        if (!border[k]) continue;
        target[k] = tree.find(k, [&](std::size_t other) {
            return std::ranges::none_of(stars[k], [&](Side out) {
                return target[cornerAt(soup, nextSide(out))] == other ||
                       target[cornerAt(soup, previousSide(out))] == other;
            });
        });
        if (target[k] == k) tree.add(k);
    }
    return target;
}

Collapses findCollapses(const Soup& soup) {
    return Collapser(soup).run();
}

} // namespace qm

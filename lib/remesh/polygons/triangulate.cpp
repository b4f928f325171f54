#include "remesh/polygons/triangulate.h"

#include "base/groups.h"
#include "base/positions.h"

#include <algorithm>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace qm {
namespace {

constexpr double pi = std::numbers::pi;

/// Combs take time proportional to the cube of their corners.
constexpr std::size_t maxCorners = 1000;

/// Cuts ears off a polygon, those with the largest smallest angle first.
class EarClipping {
public:
    EarClipping(const std::vector<PlanarPoint>& corners,
                const std::function<bool(std::size_t, std::size_t)>& mayConnect)
        : corners_(corners), mayConnect_(mayConnect), next_(corners.size()), previous_(corners.size()) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            next_[k] = (k + 1) % corners.size();
            previous_[next_[k]] = k;
        }
        for (std::size_t k = 0; k < corners.size(); ++k)
            enter(k);
    }

    /// \return the triangles; none if no ear is left before all of them are found
    std::vector<Corners> run() {
        std::vector<Corners> triangles;
        while (triangles.size() + 3 < corners_.size()) {
            const auto ear =
                std::ranges::find_if(ears_, [&](const Ear& each) { return isFree(each.second); });
            if (ear == ears_.end()) return {};
            const std::size_t tip = ear->second;
            triangles.push_back(earAt(tip));
            cutOff(tip);
        }
        triangles.push_back(earAt(triangles.empty() ? 0 : triangles.back()[0]));
        return triangles;
    }

private:
    using Ear = std::pair<double, std::size_t>; ///< minus the smallest angle, and the tip

    [[nodiscard]] Corners earAt(std::size_t tip) const { return {previous_[tip], tip, next_[tip]}; }

    /// The angles of a triangle that is counterclockwise are its turns, taken from a half turn.
    [[nodiscard]] double smallestAngle(const Corners& ear) const {
        const PlanarPoint &a = corners_[ear[0]], &b = corners_[ear[1]], &c = corners_[ear[2]];
        return pi - std::max({turn(a, b, c), turn(b, c, a), turn(c, a, b)});
    }

    [[nodiscard]] double turnAt(std::size_t k) const {
        return turn(corners_[previous_[k]], corners_[k], corners_[next_[k]]);
    }

    void enter(std::size_t k) {
        if (turnAt(k) > 0)
            ears_.emplace(-smallestAngle(earAt(k)), k);
        else
            reflex_.insert(k);
    }

    void leave(std::size_t k) {
        if (reflex_.erase(k) == 0) ears_.erase({-smallestAngle(earAt(k)), k});
    }

    void cutOff(std::size_t tip) {
        const std::size_t before = previous_[tip], behind = next_[tip];
        for (const std::size_t k : {before, tip, behind})
            leave(k);
        next_[before] = behind;
        previous_[behind] = before;
        enter(before);
        enter(behind);
    }

    /// Whether an ear may be cut off: no other corner lies in it.
    [[nodiscard]] bool isFree(std::size_t tip) const {
        const Corners ear = earAt(tip);
        if (!mayConnect_(ear[0], ear[2])) return false;
        const auto isInside = [&](const PlanarPoint& point) {
            for (std::size_t k = 0; k < 3; ++k) {
                const PlanarPoint& from = corners_[ear[k]];
                if (point == from || cross(corners_[ear[(k + 1) % 3]] - from, point - from) < 0) return false;
            }
            return true;
        };
        return std::ranges::none_of(reflex_, [&](std::size_t k) { return isInside(corners_[k]); });
    }

    const std::vector<PlanarPoint>& corners_;
    const std::function<bool(std::size_t, std::size_t)>& mayConnect_;
    std::vector<std::size_t> next_, previous_; ///< around what is left of the polygon
    std::set<Ear> ears_;                       ///< the corners that turn to the left
    std::set<std::size_t> reflex_;             ///< the others
};

/// Whether the other diagonal of a quad makes the smaller one of two triangles' smallest angles larger, as in
/// the triangulation of Delaunay.
bool isBetterTurned(const std::vector<PlanarPoint>& quad) {
    const auto isTriangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        return cross(quad[b] - quad[a], quad[c] - quad[a]) > 0;
    };
    constexpr double tie = 1e-9;
    const double apexes = 2 * pi - turn(quad[0], quad[1], quad[2]) - turn(quad[2], quad[3], quad[0]);
    return apexes > pi + tie && isTriangle(3, 0, 1) && isTriangle(1, 2, 3);
}

/// Turns diagonals as long as that makes better triangles.
void turnDiagonals(const std::vector<PlanarPoint>& corners, std::vector<Corners>& triangles,
                   const std::function<bool(std::size_t, std::size_t)>& mayConnect) {
    std::vector<bool> isTurned{true};
    for (std::size_t pass = 0; pass < corners.size() && countIn(isTurned, true) > 0; ++pass) {
        isTurned.assign(triangles.size(), false);
        for (const auto& [sides, quad] : diagonalsOf(triangles)) {
            const auto [a, b] = sides;
            if (isTurned[a] || isTurned[b] || !isBetterTurned(placesOf(corners, quad)) ||
                !mayConnect(quad[1], quad[3]))
                continue;
            triangles[a] = {quad[3], quad[0], quad[1]};
            triangles[b] = {quad[1], quad[2], quad[3]};
            isTurned[a] = isTurned[b] = true;
        }
    }
}

} // namespace

std::vector<Diagonal> diagonalsOf(const std::vector<Corners>& triangles) {
    struct Side {
        std::array<std::size_t, 2> ends;
        std::size_t triangle;
        std::size_t k;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides.push_back({{low, high}, t, k});
        }
    std::ranges::sort(sides, {}, [](const Side& side) { return std::tuple(side.ends, side.triangle); });
    std::vector<Diagonal> diagonals;
    forEachGroup(sides, &Side::ends, [&](std::span<const Side> group) {
        if (group.size() != 2) return;
        const Corners &a = triangles[group[0].triangle], &b = triangles[group[1].triangle];
        const std::size_t k = group[0].k;
        diagonals.push_back({{group[0].triangle, group[1].triangle},
                             {a[k], b[(group[1].k + 2) % 3], a[(k + 1) % 3], a[(k + 2) % 3]}});
    });
    return diagonals;
}

std::vector<PlanarPoint> placesOf(const std::vector<PlanarPoint>& corners,
                                  const std::array<std::size_t, 4>& quad) {
    return {corners[quad[0]], corners[quad[1]], corners[quad[2]], corners[quad[3]]};
}

std::vector<Corners> triangulate(const std::vector<PlanarPoint>& corners,
                                 const std::function<bool(std::size_t, std::size_t)>& mayConnect) {
    if (corners.size() > maxCorners) return {};
    std::vector<Corners> triangles = EarClipping(corners, mayConnect).run();
    turnDiagonals(corners, triangles, mayConnect);
    return triangles;
}

} // namespace qm

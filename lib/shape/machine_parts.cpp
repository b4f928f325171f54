#include "base/at.h"
#include "shape/round_hole.h"
#include "shape/sample_meshes.h"
#include "shape/voxels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

using Place = RoundHole::Place;

/// A quarter circle of radius 1 that leaves one line and ends on another at right angles.
/// \param share  of the turn, 0 to 1
/// \return x along the first line, y away from it
Place quarterCircle(double share) {
    const double angle = share * std::numbers::pi / 2;
    return {std::sin(angle), 1 - std::cos(angle)};
}

constexpr RoundHole drilledHole{.hole = 0.5, .frame = 1.5, .radius = 0.75};

/// With a hole around an axis along z made round.
Point rounded(const Point& point, const RoundHole& hole, Place axis) {
    const Place place = hole.moved({point[0] - axis.x, point[1] - axis.y});
    return {place.x + axis.x, place.y + axis.y, point[2]};
}

/// Turns the hole through the middle of the block into a round one with filleted rims.
Point blockPoint(const Point& point, double middle, double height) {
    constexpr RoundHole hole{.hole = 0.5, .frame = 1.5, .radius = 0.6};
    constexpr double fillet = 0.35;
    constexpr double band = 0.4; // of the frame's width becomes half of the fillet
    const Place place{point[0] - middle, point[1] - middle};
    const double outward = hole.outwardness(place);
    if (outward >= 1) return point;
    const bool above = 2 * point[2] > height;
    const double depth = above ? height - point[2] : point[2];
    const auto put = [&](Place at, double down) {
        return Point(at.x + middle, at.y + middle, above ? height - down : down);
    };
    if (outward >= band) { // what remains flat, between the fillet and the outer edges
        RoundHole flat = hole;
        flat.radius += fillet;
        return put(flat.at(place, (outward - band) / (1 - band)), 0);
    }
    // Half of the fillet lies on what was the frame, half on what was the wall of the hole.
    const double share = outward > 0 ? (1 - outward / band) / 2 : std::min((1 + depth / fillet) / 2, 1.0);
    const auto [along, down] = quarterCircle(share);
    RoundHole rim = hole;
    rim.radius += fillet * (1 - along);
    return put(rim.at(place, 0), share < 1 ? fillet * down : depth);
}

/// Rounds the concave corner of an L at the origin: solid is where x or y is negative, down to -1.
Place filletedCorner(Place place, double radius) {
    const double share = std::max({place.x, place.y, 0.0}) / radius;
    if (share >= 1) return place;
    const auto [along, away] = quarterCircle((1 + share) / 2);
    // The surface moves onto the circle, and what lies below it moves less and less.
    const double depth = std::clamp(-std::min(place.x, place.y), 0.0, 1.0);
    const double far = (1 - depth) * radius * (away - share), near = (1 - depth) * radius * (1 - along);
    return place.x >= place.y ? Place{place.x + far, place.y + near} : Place{place.x + near, place.y + far};
}

Point bracketPoint(Point point) {
    constexpr RoundHole hole = drilledHole;
    constexpr double middle = 1.5, far = 4.5, fillet = 1.5;
    const Place bent = filletedCorner({point[0] - 1, point[2] - 1}, fillet);
    point[0] = 1 + bent.x;
    point[2] = 1 + bent.y;
    if (point[2] <= 1 && point[0] >= far - hole.frame) return rounded(point, hole, {far, middle});
    if (point[0] <= 1 && point[2] >= far - hole.frame) {
        const Place place = hole.moved({point[1] - middle, point[2] - far});
        return {point[0], place.x + middle, place.y + far};
    }
    return point;
}

template <class Move> QuadList moved(QuadList list, const Move& move) {
    for (Point& point : list.points)
        point = move(point);
    return list;
}

} // namespace

QuadList blockShape(int n) {
    Voxels voxels = voxelBox(3, 3, 2);
    for (const int level : {0, 1})
        voxels.erase({1, 1, level});
    return moved(refined(voxelSurface(voxels), n),
                 [](const Point& point) { return blockPoint(point, 1.5, 2); });
}

QuadList bracketShape(int n) {
    Voxels voxels = voxelBox(6, 3, 1);
    voxels.merge(voxelBox(1, 3, 6));
    voxels.erase({4, 1, 0});
    voxels.erase({0, 1, 4});
    return moved(refined(voxelSurface(voxels), n), bracketPoint);
}

QuadList plateShape(int n) {
    constexpr RoundHole hole{.hole = 0.2, .frame = 0.5, .radius = 0.3};
    constexpr Place middle{2.5, 1.5};
    const GridTopology grid{.columns = 5, .rows = 3};
    QuadList sheet = grid.withPoints([](int column, int row) { return Point(column, row, 0); });
    // A ring of four quads takes the place of the middle one.
    constexpr std::size_t place = 7;
    const std::array<int, 4> outer = sheet.quads[place];
    sheet.quads.erase(sheet.quads.begin() + place);
    const int inner = static_cast<int>(sheet.points.size());
    for (int k = 0; k < 4; ++k) {
        const std::size_t corner = at(k);
        const Point& point = sheet.points[at(outer[corner])];
        const Point centre(middle.x, middle.y, 0);
        sheet.points.push_back(centre + (point - centre) * (hole.hole / hole.frame));
        sheet.quads.push_back({outer[corner], outer[(corner + 1) % 4], inner + (k + 1) % 4, inner + k});
    }
    return moved(refined(sheet, n), [&](const Point& point) { return rounded(point, hole, middle); });
}

QuadList drilledShape(int n, int holes) {
    constexpr RoundHole hole = drilledHole;
    Voxels voxels = voxelBox(3 * holes, 3, 1);
    for (int k = 0; k < holes; ++k)
        voxels.erase({3 * k + 1, 1, 0});
    return moved(refined(voxelSurface(voxels), n), [&](const Point& point) {
        const double nearest = std::min(std::floor(point[0] / 3), holes - 1.0);
        return rounded(point, hole, {3 * nearest + 1.5, 1.5});
    });
}

} // namespace qm

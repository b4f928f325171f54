#include "shape/machine_parts.h"

#include "shape/round_hole.h"
#include "shape/voxels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace qm {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;

/// A quarter circle that leaves a straight line for another at right angles. \param share  of the turn, 0 to 1
/// \return how far it has gone along the first line, and away from it, in radii
RoundHole::Place filletAt(double share) {
    const double angle = share * quarterTurn;
    return {std::sin(angle), 1 - std::cos(angle)};
}

/// Turns the hole through the middle of the block into a round one with filleted rims.
Point blockPoint(const Point& point, double height) {
    constexpr RoundHole hole{.hole = 0.5, .frame = 1.5, .radius = 0.6};
    constexpr double fillet = 0.35;
    constexpr double band = 0.4; // of the frame's width that becomes half of the fillet
    const RoundHole::Place place{point[0] - 1.5, point[1] - 1.5};
    const double outward = hole.outwardness(place);
    const bool above = 2 * point[2] > height;
    const double depth = above ? height - point[2] : point[2];
    const auto put = [&](RoundHole::Place at, double down) {
        return Point(at.x + 1.5, at.y + 1.5, above ? height - down : down);
    };
    if (outward >= 1) return point;
    if (outward >= band) { // the flat part, between the fillet and the outer edges
        RoundHole flat = hole;
        flat.radius += fillet;
        return put(flat.at(place, (outward - band) / (1 - band)), depth);
    }
    // Half of the fillet lies on what was the frame, half on what was the wall of the hole.
    const double share = outward > 0 ? (1 - outward / band) / 2 : std::min((1 + depth / fillet) / 2, 1.0);
    const auto [along, down] = filletAt(share);
    RoundHole rim = hole;
    rim.radius += fillet * (1 - along);
    return put(rim.at(place, 0), share < 1 ? fillet * down : depth);
}

/// Rounds the concave corner at the origin of an L: the solid is where x or z is negative.
RoundHole::Place cornerPoint(RoundHole::Place place, double radius) {
    const bool alongX = place.x >= place.z_();
    (void)alongX;
    return {place.x * radius, place.y};
}

} // namespace
} // namespace qm

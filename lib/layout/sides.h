/// \file The four sides of a grid of quads, which are numbered as in `Segment`: counter-clockwise from the
/// one along which the column, or u, rises. The row, or v, rises along the next one.
#pragma once

#include <array>
#include <cstddef>

namespace qm {

/// The direction that runs along a side: 0 for u, 1 for v.
constexpr std::size_t directionAlong(int side) {
    return side % 2 == 0 ? 0 : 1;
}

constexpr std::size_t directionAcross(int side) {
    return 1 - directionAlong(side);
}

/// Whether the direction across a side ends there, and does not begin.
constexpr bool isFarSide(int side) {
    return side == 1 || side == 2;
}

/// Whether a side, walked counter-clockwise, runs against the direction along it.
constexpr bool isReversed(int side) {
    return side >= 2;
}

/// The side at which u (0) or v (1) begins, or ends if it `isFar`.
constexpr int sideAcross(std::size_t direction, bool isFar) {
    return direction == 0 ? (isFar ? 1 : 3) : (isFar ? 2 : 0);
}

/// From the distance from a side's beginning to the place in the direction along it; and back, for it is its
/// own inverse.
/// \param length  of the side
template <class Number> constexpr Number alongSide(int side, Number distance, Number length) {
    return isReversed(side) ? length - distance : distance;
}

/// The column and row, or u and v, at a distance from a side's beginning.
/// \param size  of the grid in both directions
template <class Size, class Number>
constexpr std::array<Number, 2> placeOnSide(const std::array<Size, 2>& size, int side, Number distance) {
    const std::size_t along = directionAlong(side);
    const std::size_t across = directionAcross(side);
    std::array<Number, 2> place{};
    place[along] = alongSide(side, distance, static_cast<Number>(size[along]));
    if (isFarSide(side)) place[across] = static_cast<Number>(size[across]);
    return place;
}

/// The number of a point in an array of columns and rows, from its place along a side's direction.
/// \param count  of columns and rows
/// \param layer  how many points away from the side
constexpr std::size_t pointOnSide(const std::array<std::size_t, 2>& count, int side, std::size_t k,
                                  std::size_t layer = 0) {
    const std::size_t across = directionAcross(side);
    std::array<std::size_t, 2> place{};
    place[directionAlong(side)] = k;
    place[across] = isFarSide(side) ? count[across] - 1 - layer : layer;
    return place[1] * count[0] + place[0];
}

} // namespace qm
